// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/inflating_stream.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"

#include <zlib.h>

#include <algorithm>
#include <cstring>

namespace corticle::formats
{

namespace
{

constexpr int gzip_window = 15 + 16; ///< zlib's number for the largest window, with a gzip header
constexpr std::size_t largest_piece = std::size_t{1} << 30;

/// zlib does not write to its input but takes it as if it did.
Bytef* input_of(std::string_view bytes)
{
    return const_cast<Bytef*>(reinterpret_cast<const Bytef*>(bytes.data()));
}

bool starts_gzip(std::string_view bytes)
{
    return bytes.substr(0, 2) == "\x1f\x8b";
}

} // namespace

struct InflatingStream::Inflater
{
    z_stream zlib{};
    bool ended = false;

    Inflater()
    {
        if (inflateInit2(&zlib, gzip_window) != Z_OK)
        {
            throw RunError("cannot decompress: not enough memory for zlib");
        }
    }
    Inflater(const Inflater&) = delete;
    Inflater& operator=(const Inflater&) = delete;
    ~Inflater() { inflateEnd(&zlib); }
};

InflatingStream::InflatingStream(std::string_view bytes, std::string name) : left_(bytes), name_(std::move(name))
{
    if (starts_gzip(left_))
    {
        inflater_ = std::make_unique<Inflater>();
    }
}

InflatingStream::~InflatingStream() = default;

std::size_t InflatingStream::most_left() const
{
    constexpr std::size_t ratio = 1032;
    constexpr std::size_t window = 65536; // taken in, not yet given out
    return compressed() ? left_.size() * ratio + window : left_.size();
}

std::size_t InflatingStream::read(char* to, std::size_t count)
{
    if (!compressed())
    {
        const std::size_t taken = std::min(count, left_.size());
        std::memcpy(to, left_.data(), taken);
        left_.remove_prefix(taken);
        return taken;
    }
    z_stream& zlib = inflater_->zlib;
    std::size_t done = 0;
    while (done < count && !inflater_->ended)
    {
        const std::size_t room = std::min(count - done, largest_piece);
        const std::size_t offered = std::min(left_.size(), largest_piece);
        zlib.next_in = input_of(left_);
        zlib.avail_in = static_cast<uInt>(offered);
        zlib.next_out = reinterpret_cast<Bytef*>(to + done);
        zlib.avail_out = static_cast<uInt>(room);
        const int status = inflate(&zlib, Z_NO_FLUSH);
        left_.remove_prefix(offered - zlib.avail_in);
        done += room - zlib.avail_out;
        if (status == Z_STREAM_END)
        {
            // A gzip file may hold several streams, one after another.
            inflater_->ended = !starts_gzip(left_) || inflateReset(&zlib) != Z_OK;
        }
        else if (status == Z_BUF_ERROR || (status == Z_OK && left_.empty() && zlib.avail_out > 0))
        {
            fail_reading(name_, "truncated gzip", "its end in the middle of the compressed data", "the whole file");
        }
        else if (status != Z_OK)
        {
            fail_reading(name_, "damaged gzip", zlib.msg != nullptr ? zlib.msg : "invalid data", "gzip data");
        }
    }
    return done;
}

std::string gzip(std::string_view bytes)
{
    constexpr int memory_level = 8; // zlib's default
    z_stream zlib{};
    if (deflateInit2(&zlib, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, memory_level, Z_DEFAULT_STRATEGY) != Z_OK)
    {
        throw RunError("cannot compress: not enough memory for zlib");
    }
    std::string result;
    std::string piece(std::size_t{1} << 18, '\0');
    int status = Z_OK;
    while (status == Z_OK || status == Z_BUF_ERROR)
    {
        const std::size_t offered = std::min(bytes.size(), largest_piece);
        zlib.next_in = input_of(bytes);
        zlib.avail_in = static_cast<uInt>(offered);
        zlib.next_out = reinterpret_cast<Bytef*>(piece.data());
        zlib.avail_out = static_cast<uInt>(piece.size());
        status = deflate(&zlib, offered == bytes.size() ? Z_FINISH : Z_NO_FLUSH);
        bytes.remove_prefix(offered - zlib.avail_in);
        result.append(piece, 0, piece.size() - zlib.avail_out);
    }
    deflateEnd(&zlib);
    return result;
}

} // namespace corticle::formats

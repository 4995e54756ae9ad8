// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/checksum.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

namespace corticle::formats
{

namespace
{

constexpr std::string_view line_start = "<!-- checksum ";
constexpr std::string_view line_end = " -->\n";
constexpr std::size_t digits = 16;
constexpr std::size_t line_size = line_start.size() + digits + line_end.size();

std::string line_of(std::uint64_t sum)
{
    return fmt::format("{}{:016x}{}", line_start, sum, line_end);
}

std::uint64_t start_of(std::uint64_t size)
{
    return 0xcbf29ce484222325u ^ size;
}

/// Goes on over bytes; but for the last ones, whole words.
std::uint64_t over(std::uint64_t hash, std::string_view bytes)
{
    for (std::size_t at = 0; at < bytes.size(); at += 8)
    {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
        hash = (hash ^ word) * 0x100000001b3u;
        hash ^= hash >> 32;
    }
    return hash;
}

std::uint64_t finished(std::uint64_t hash)
{
    return hash * 0x9e3779b97f4a7c15u;
}

} // namespace

std::uint64_t checksum(std::string_view bytes)
{
    return finished(over(start_of(bytes.size()), bytes));
}

std::string checksum_line(std::string_view bytes)
{
    return line_of(checksum(bytes));
}

void append_checksum(const std::filesystem::path& file, const std::string& name)
{
    std::error_code error;
    std::uint64_t hash = start_of(std::filesystem::file_size(file, error));
    std::ifstream stream(file, std::ios::binary);
    std::string piece(std::size_t{1} << 20, '\0');
    while (stream.read(piece.data(), std::ssize(piece)) || stream.gcount() > 0)
    {
        hash = over(hash, std::string_view(piece).substr(0, static_cast<std::size_t>(stream.gcount())));
    }
    errno = 0;
    std::ofstream end(file, std::ios::binary | std::ios::app);
    end << line_of(finished(hash));
    end.flush();
    if (error || stream.bad() || !end)
    {
        const int reason = errno;
        throw RunError(fmt::format("cannot write {}: {}", name,
                                   reason != 0 ? std::generic_category().message(reason)
                                               : "what was written of it cannot be read again"));
    }
}

void require_checksum(std::string_view bytes, const std::string& name)
{
    const std::size_t before = bytes.size() - std::min(bytes.size(), line_size);
    const std::string_view line = bytes.substr(before);
    if (line.starts_with(line_start) && line.ends_with(line_end) && line != checksum_line(bytes.substr(0, before)))
    {
        fail_reading(name, "damaged, or changed by hand", "bytes that do not match the checksum in its last line",
                     "a file as it was written (without its last line any content will do)");
    }
}

} // namespace corticle::formats

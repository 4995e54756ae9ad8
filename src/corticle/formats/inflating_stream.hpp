// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Takes bytes off memory that may be gzip-compressed (recognised by its first two bytes, not by a name), decompressing
/// no more than is asked for.
class InflatingStream
{
  public:
    /// `name` of the file, for messages. The bytes must outlive the stream.
    InflatingStream(std::string_view bytes, std::string name);
    ~InflatingStream();
    InflatingStream(const InflatingStream&) = delete;
    InflatingStream& operator=(const InflatingStream&) = delete;

    /// Fills `to` with the next `count` bytes; returns how many there were.
    /// @throws InputError when the compressed bytes are damaged or truncated.
    std::size_t read(char* to, std::size_t count);

    /// More bytes than this there cannot be, from here on (deflate makes at most 1032 bytes of one).
    std::size_t most_left() const;

    bool compressed() const { return inflater_ != nullptr; }

  private:
    struct Inflater;

    std::string_view left_; ///< not yet taken
    std::string name_;
    std::unique_ptr<Inflater> inflater_;
};

/// The bytes as a gzip file, the same whenever it is made. @throws RunError when memory is short.
std::string gzip(std::string_view bytes);

} // namespace corticle::formats

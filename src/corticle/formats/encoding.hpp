// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace corticle::formats
{

// How XML files carry binary data. Base64 is decoded by ByteSource (byte_source.hpp).

/// True when `packed`, a zlib stream, unpacks to exactly `size` bytes at `out`.
bool unpack_zlib(std::string_view packed, char* out, std::size_t size);
/// The same for a block of LZ4.
bool unpack_lz4(std::string_view packed, char* out, std::size_t size);

/// A zlib stream.
std::string pack_zlib(std::string_view bytes);

/// Base64 without line breaks.
std::string to_base64(std::string_view bytes);

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// A file that may be gzip-compressed, as it is without that.
struct PlainFile
{
    std::string bytes;
    std::string extension; ///< in lower case, without its dot and without .gz
};

/// Reads a file whole and unpacks it where its first bytes are those of gzip, whatever its name.
/// @throws InputError, one line, when it cannot be read, is damaged, or unpacks to far more than meshes and maps do
PlainFile read_plain_file(const std::filesystem::path& file);

/// Bytes as they are without gzip; `name` is used in messages. @throws InputError
std::string unpacked(std::string_view bytes, const std::string& name);

/// The ending of the file inside: lower case, without its dot and without .gz.
std::string plain_extension(const std::filesystem::path& file);

} // namespace corticle::formats

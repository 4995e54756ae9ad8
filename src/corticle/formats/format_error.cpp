// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <system_error>

namespace corticle::formats
{

namespace
{

constexpr std::size_t longest_quote = 60;
constexpr std::uintmax_t largest_file = std::uintmax_t{4} << 30;

} // namespace

void fail_reading(std::string_view file, std::string_view what, std::string_view got, std::string_view expected)
{
    std::string line = fmt::format("{}: {}; got {}{}; expected {}", file, what, got.substr(0, longest_quote),
                                   got.size() > longest_quote ? "..." : "", expected);
    const auto unprintable = [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; };
    std::replace_if(line.begin(), line.end(), unprintable, '?');
    throw InputError(line);
}

std::string read_whole_file(const std::filesystem::path& file)
{
    const std::string name = file.string();
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
    {
        fail_reading(name, "cannot be opened", error ? error.message() : "no such file", "a file");
    }
    if (std::filesystem::is_directory(status))
    {
        fail_reading(name, "cannot be read", "a directory", "a file");
    }
    const std::uintmax_t size = std::filesystem::file_size(file, error);
    if (error)
    {
        fail_reading(name, "cannot be read", error.message(), "a plain file");
    }
    if (size > largest_file)
    {
        fail_reading(name, "too large", fmt::format("{} bytes", size), "at most 4 GiB");
    }
    std::ifstream stream(file, std::ios::binary);
    if (!stream)
    {
        fail_reading(name, "cannot be opened", "no access", "a file that can be read");
    }
    std::string bytes(static_cast<std::size_t>(size), '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(size));
    if (static_cast<std::uintmax_t>(stream.gcount()) != size)
    {
        fail_reading(name, "cannot be read to its end", fmt::format("{} bytes", stream.gcount()),
                     fmt::format("{}", size));
    }
    return bytes;
}

std::string lower_case_extension(const std::filesystem::path& file)
{
    std::string extension = file.extension().string();
    extension.erase(0, 1);
    return lower_case(extension);
}

} // namespace corticle::formats

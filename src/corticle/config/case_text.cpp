// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/case_text.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/value.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iostream>
#include <iterator>

namespace corticle::config
{

namespace
{

constexpr std::uintmax_t longest = 1 << 20;

} // namespace

std::string read_case_text(const std::filesystem::path& file, std::string_view what)
{
    const auto refuse = [&](std::string_view reason)
    { return InputError(fmt::format("cannot read {} {}: {}", what, printable(file.string()), reason)); };
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    if (!std::filesystem::exists(status))
    {
        throw refuse(error && error != std::errc::no_such_file_or_directory ? error.message() : "no such file");
    }
    if (!std::filesystem::is_regular_file(status))
    {
        throw refuse("got a directory or device, expected a TOML file");
    }
    if (const auto size = std::filesystem::file_size(file, error); !error && size > longest)
    {
        throw refuse(fmt::format("got {} bytes, expected a TOML file of at most {}", size, longest));
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
    if (!stream.is_open() || stream.bad())
    {
        throw refuse("no permission, or a failing disk");
    }
    return text;
}

bool is_standard_input(const std::filesystem::path& file)
{
    return file == "-";
}

std::string read_standard_input()
{
    std::string text(longest + 1, '\0');
    std::cin.read(text.data(), static_cast<std::streamsize>(text.size()));
    const auto there = static_cast<std::size_t>(std::cin.gcount());
    if (std::cin.bad() || there == 0 || there > longest)
    {
        throw InputError(fmt::format("cannot read the case from the standard input: got {}, expected a TOML file of at "
                                     "most {} bytes",
                                     there == 0 ? "nothing" : "too many bytes", longest));
    }
    text.resize(there);
    return text;
}

} // namespace corticle::config

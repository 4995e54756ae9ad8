// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/plain_file.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/inflating_stream.hpp"

#include <fmt/format.h>

namespace corticle::formats
{

namespace
{

// Text of a mesh shrinks five times, a map of one number a thousand times: what may come of a packed file.
constexpr std::size_t largest_growth = 100;
constexpr std::size_t free_growth = std::size_t{64} << 20;

} // namespace

std::string unpacked(std::string_view bytes, const std::string& name)
{
    InflatingStream stream(bytes, name);
    const std::size_t most = free_growth + largest_growth * bytes.size();
    std::string plain;
    std::string piece(std::size_t{1} << 20, '\0');
    for (std::size_t there = piece.size(); there == piece.size();)
    {
        there = stream.read(piece.data(), piece.size());
        plain.append(piece, 0, there);
        if (plain.size() > most)
        {
            fail_reading(name, "unpacks to more than any mesh or map does",
                         fmt::format("over {} bytes of {}", most, bytes.size()), "a file as it was packed");
        }
    }
    return plain;
}

PlainFile read_plain_file(const std::filesystem::path& file)
{
    std::string bytes = read_whole_file(file);
    const bool is_packed = InflatingStream(bytes, file.string()).compressed();
    return {is_packed ? unpacked(bytes, file.string()) : std::move(bytes), plain_extension(file)};
}

std::string plain_extension(const std::filesystem::path& file)
{
    const std::string last = lower_case_extension(file);
    return last == "gz" ? lower_case_extension(file.stem()) : last;
}

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/volume_numbers.hpp"

#include "corticle/formats/companion_files.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/plain_file.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace corticle::formats
{

namespace
{

constexpr std::size_t piece_bytes = std::size_t{1} << 20;

template <class Number>
void convert(const std::string& bytes, std::size_t count, bool big_endian, std::vector<double>& numbers)
{
    for (std::size_t k = 0; k < count; ++k)
    {
        numbers[k] = static_cast<double>(load<Number>(bytes.data() + k * sizeof(Number), big_endian));
    }
}

void convert(const VolumeHeader& header, const std::string& bytes, std::size_t count, std::vector<double>& numbers)
{
    using enum NumberType;
    switch (header.type)
    {
    case uint8:
        return convert<std::uint8_t>(bytes, count, header.big_endian, numbers);
    case int16:
        return convert<std::int16_t>(bytes, count, header.big_endian, numbers);
    case int32:
        return convert<std::int32_t>(bytes, count, header.big_endian, numbers);
    case float32:
        return convert<float>(bytes, count, header.big_endian, numbers);
    case float64:
        return convert<double>(bytes, count, header.big_endian, numbers);
    case int8:
        return convert<std::int8_t>(bytes, count, header.big_endian, numbers);
    case uint16:
        return convert<std::uint16_t>(bytes, count, header.big_endian, numbers);
    case uint32:
        return convert<std::uint32_t>(bytes, count, header.big_endian, numbers);
    case int64:
        return convert<std::int64_t>(bytes, count, header.big_endian, numbers);
    case uint64:
        return convert<std::uint64_t>(bytes, count, header.big_endian, numbers);
    }
}

} // namespace

bool is_volume(const std::filesystem::path& file)
{
    constexpr std::array<std::string_view, 5> known{"nii", "hdr", "img", "mgh", "mgz"};
    return std::ranges::find(known, plain_extension(file)) != known.end();
}

VolumeFile::VolumeFile(const std::filesystem::path& file)
{
    const std::filesystem::path other = other_of_pair(file);
    const bool is_image = plain_extension(file) == "img";
    if (is_image && other.empty())
    {
        fail_reading(file.string(), "the image of a pair", "no header (.hdr) beside it", "both");
    }
    header_ = read_whole_file(is_image ? other : file);
    if (!other.empty())
    {
        image_ = read_whole_file(is_image ? file : other);
    }
}

VolumeNumbers::VolumeNumbers(const VolumeBytes& bytes, const std::string& name, Coordinates coordinates)
    : name_(name), stream_(bytes.header, name), header_(read_volume_header(stream_, name, coordinates))
{
    if (header_.is_pair && bytes.image.empty())
    {
        fail_reading(name, "the header of a pair", "no image (.img) beside it", "both, or a single .nii or .nii.gz");
    }
    if (header_.is_pair)
    {
        image_.emplace(bytes.image, name);
    }
    const InflatingStream& data = header_.is_pair ? *image_ : stream_;
    const std::size_t announced =
        header_.skip + header_.voxels() * static_cast<std::size_t>(header_.volumes) * size_of(header_.type);
    if (announced > data.most_left())
    {
        fail_reading(name, "data shorter than announced", fmt::format("at most {} bytes", data.most_left()),
                     fmt::format("{}", announced));
    }
    piece_.resize(piece_bytes);
}

std::size_t VolumeNumbers::read_piece(std::size_t bytes)
{
    return (image_ ? *image_ : stream_).read(piece_.data(), std::min(bytes, piece_.size()));
}

void VolumeNumbers::skip(std::size_t bytes)
{
    for (std::size_t done = 0; done < bytes;)
    {
        const std::size_t there = read_piece(bytes - done);
        if (there == 0)
        {
            fail_reading(name_, "data shorter than announced", fmt::format("{} bytes before the numbers", done),
                         fmt::format("{}", bytes));
        }
        done += there;
    }
}

void VolumeNumbers::read(std::int64_t volume, std::int64_t count, const Take& take)
{
    const std::size_t number = size_of(header_.type);
    const std::size_t wanted = header_.voxels() * static_cast<std::size_t>(count);
    skip(header_.skip + header_.voxels() * static_cast<std::size_t>(volume) * number);
    std::vector<double> numbers(piece_bytes / number);
    for (std::size_t done = 0; done < wanted;)
    {
        const std::size_t now = std::min(numbers.size(), wanted - done);
        const std::size_t there = read_piece(now * number);
        if (there < now * number)
        {
            fail_reading(name_, "data shorter than announced", fmt::format("{} bytes", done * number + there),
                         fmt::format("{}", wanted * number));
        }
        convert(header_, piece_, now, numbers);
        if (header_.slope != 1.0 || header_.intercept != 0.0)
        {
            std::ranges::transform(numbers, numbers.begin(),
                                   [&](double raw) { return header_.slope * raw + header_.intercept; });
        }
        take(std::span<const double>(numbers).first(now), done);
        done += now;
    }
    if (volume + count == header_.volumes)
    {
        read_piece(1); // past the end, where gzip keeps its check sum
    }
}

std::int64_t chosen_volume(const VolumeHeader& header, std::optional<std::int64_t> volume, const std::string& name)
{
    if (header.volumes > 1 && !volume)
    {
        fail_reading(name, "a 4D image: which volume?", fmt::format("{} volumes", header.volumes),
                     fmt::format("one, or a choice from 0 to {}", header.volumes - 1));
    }
    const std::int64_t chosen = volume.value_or(0);
    if (chosen < 0 || chosen >= header.volumes)
    {
        fail_reading(name, "no such volume", fmt::format("{}", chosen), fmt::format("0 to {}", header.volumes - 1));
    }
    return chosen;
}

void require_memory(const VolumeHeader& header, std::size_t bytes_per_voxel, const std::string& name)
{
    const double needed = static_cast<double>(header.voxels()) * static_cast<double>(bytes_per_voxel);
    const double there = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGE_SIZE));
    if (needed > there)
    {
        fail_reading(name, "an image too large for this machine",
                     fmt::format("{} x {} x {} voxels, which take {:.3g} GiB", header.size[0], header.size[1],
                                 header.size[2], needed / 0x1p30),
                     fmt::format("at most {:.3g} GiB", there / 0x1p30));
    }
}

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/volumes/nifti.hpp"
#include "corticle/formats/volumes/nifti_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::formats
{

namespace
{

/// Numbers are read and turned into labels piece by piece.
constexpr std::size_t piece_bytes = std::size_t{1} << 20;

std::size_t chosen_volume(const NiftiHeader& header, std::optional<std::int64_t> volume, const std::string& name)
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
    return static_cast<std::size_t>(chosen);
}

/// Turns the numbers of an image into labels, and counts those that are not labels.
class LabelReader
{
  public:
    LabelReader(const NiftiHeader& header, const std::string& name) : header_(header), name_(name) {}

    void append(const char* bytes, std::size_t count, std::vector<std::int32_t>& labels)
    {
        using enum NiftiType;
        switch (header_.type)
        {
        case uint8:
            return convert<std::uint8_t>(bytes, count, labels);
        case int16:
            return convert<std::int16_t>(bytes, count, labels);
        case int32:
            return convert<std::int32_t>(bytes, count, labels);
        case float32:
            return convert<float>(bytes, count, labels);
        case float64:
            return convert<double>(bytes, count, labels);
        case int8:
            return convert<std::int8_t>(bytes, count, labels);
        case uint16:
            return convert<std::uint16_t>(bytes, count, labels);
        case uint32:
            return convert<std::uint32_t>(bytes, count, labels);
        case int64:
            return convert<std::int64_t>(bytes, count, labels);
        case uint64:
            return convert<std::uint64_t>(bytes, count, labels);
        }
    }

    void require_labels(std::size_t count) const
    {
        if (not_whole_ > 0)
        {
            refuse("are not whole numbers: not an image of labels", not_whole_, count);
        }
        if (out_of_range_ > 0)
        {
            refuse("are beyond 32-bit labels", out_of_range_, count);
        }
    }

  private:
    template <class Number>
    void convert(const char* bytes, std::size_t count, std::vector<std::int32_t>& labels)
    {
        for (std::size_t k = 0; k < count; ++k)
        {
            const auto raw = static_cast<double>(number_at<Number>(bytes + k * sizeof(Number), header_.swapped));
            const double scaled = header_.slope * raw;
            const double value = scaled + header_.intercept;
            const double whole = std::nearbyint(value);
            const bool is_whole =
                imaging::is_whole_label(value, std::max(std::abs(scaled), std::abs(header_.intercept)));
            const bool fits = std::abs(whole) <= static_cast<double>(std::numeric_limits<std::int32_t>::max());
            if (!is_whole || !fits)
            {
                note(value, labels.size(), is_whole);
            }
            labels.push_back(is_whole && fits ? static_cast<std::int32_t>(whole) : 0);
        }
    }

    void note(double value, std::size_t voxel, bool is_whole)
    {
        if (not_whole_ + out_of_range_ == 0 || (!is_whole && not_whole_ == 0))
        {
            first_ = value;
            first_voxel_ = voxel;
        }
        ++(is_whole ? out_of_range_ : not_whole_);
    }

    [[noreturn]] void refuse(std::string_view what, std::size_t bad, std::size_t count) const
    {
        const auto width = static_cast<std::size_t>(header_.size[0]);
        const auto height = static_cast<std::size_t>(header_.size[1]);
        fail_reading(name_, fmt::format("{} of {} voxels {}", bad, count, what),
                     fmt::format("{:.9g} at voxel ({}, {}, {})", first_, first_voxel_ % width,
                                 first_voxel_ / width % height, first_voxel_ / (width * height)),
                     "whole labels");
    }

    const NiftiHeader& header_;
    const std::string& name_;
    std::size_t not_whole_ = 0;
    std::size_t out_of_range_ = 0;
    double first_ = 0.0;
    std::size_t first_voxel_ = 0;
};

[[noreturn]] void fail_short(const std::string& name, std::size_t there, std::size_t announced)
{
    fail_reading(name, "data shorter than announced", fmt::format("{} bytes", there), fmt::format("{}", announced));
}

void skip(InflatingStream& stream, std::size_t count, std::string& piece, const std::string& name)
{
    for (std::size_t done = 0; done < count;)
    {
        const std::size_t there = stream.read(piece.data(), std::min(count - done, piece.size()));
        if (there == 0)
        {
            fail_short(name, done, count);
        }
        done += there;
    }
}

} // namespace

bool is_nifti(const std::filesystem::path& file)
{
    const std::string last = lower_case_extension(file);
    return last == "nii" || last == "hdr" || last == "img" ||
           (last == "gz" && lower_case_extension(file.stem()) == "nii");
}

imaging::LabelVolume parse_nifti(std::string_view bytes, const std::string& name, const NiftiChoice& choice)
{
    InflatingStream stream(bytes, name);
    const NiftiHeader header = read_nifti_header(stream, name, choice.coordinates);
    imaging::LabelVolume image;
    image.size = header.size;
    image.frame = header.frame;
    image.notes = header.notes;
    const std::size_t number = size_of(header.type);
    const auto voxels = static_cast<std::size_t>(header.size[0] * header.size[1] * header.size[2]);
    const std::size_t chosen = chosen_volume(header, choice.volume, name);
    const std::size_t before = header.skip + chosen * voxels * number;
    const std::size_t announced = before + voxels * number;
    if (announced > stream.most_left())
    {
        fail_reading(name, "data shorter than announced", fmt::format("at most {} bytes", stream.most_left()),
                     fmt::format("{}", announced));
    }
    std::string piece(std::min(piece_bytes, announced), '\0');
    skip(stream, before, piece, name);
    image.labels.reserve(voxels);
    LabelReader reader(header, name);
    while (image.labels.size() < voxels)
    {
        const std::size_t wanted = std::min(piece_bytes / number, voxels - image.labels.size());
        const std::size_t there = stream.read(piece.data(), wanted * number);
        if (there < wanted * number)
        {
            fail_short(name, image.labels.size() * number + there, voxels * number);
        }
        reader.append(piece.data(), wanted, image.labels);
    }
    if (chosen + 1 == static_cast<std::size_t>(header.volumes))
    {
        stream.read(piece.data(), 1); // past the end, where gzip keeps its check sum
    }
    reader.require_labels(voxels);
    return image;
}

imaging::LabelVolume read_nifti(const std::filesystem::path& file, const NiftiChoice& choice)
{
    const std::string bytes = read_whole_file(file);
    return parse_nifti(bytes, file.string(), choice);
}

} // namespace corticle::formats

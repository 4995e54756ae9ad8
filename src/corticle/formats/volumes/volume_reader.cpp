// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/volume_reader.hpp"

#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::formats
{

namespace
{

/// Images of zeros alone are kept up to this size: beyond it they are a few bytes made large.
constexpr std::size_t most_empty_voxels = std::size_t{1} << 26;

/// Turns the numbers of an image into labels, and counts those that are not labels. Takes no memory before the first
/// label that is not 0.
class LabelReader
{
  public:
    LabelReader(const VolumeHeader& header, std::optional<double> threshold, const std::string& name)
        : header_(header), threshold_(threshold), name_(name)
    {
    }

    void take(std::span<const double> numbers, std::size_t first)
    {
        for (std::size_t k = 0; k < numbers.size(); ++k)
        {
            const std::int32_t label = threshold_ ? above_threshold(numbers[k]) : whole_label(numbers[k], first + k);
            if (label != 0 && labels_.empty())
            {
                allocate();
            }
            if (!labels_.empty())
            {
                labels_[first + k] = label;
            }
        }
    }

    std::vector<std::int32_t> finish()
    {
        if (not_whole_ > 0)
        {
            refuse("are not whole numbers: not an image of labels", not_whole_,
                   "whole labels (geometry.threshold takes a map of probabilities)");
        }
        if (out_of_range_ > 0)
        {
            refuse("are beyond 32-bit labels", out_of_range_, "whole labels");
        }
        if (labels_.empty() && header_.voxels() > most_empty_voxels)
        {
            fail_reading(name_, "an image of nothing", fmt::format("{} voxels of 0", header_.voxels()),
                         "some with a label");
        }
        if (labels_.empty())
        {
            allocate();
        }
        return std::move(labels_);
    }

    std::size_t not_numbers() const { return not_numbers_; }

  private:
    void allocate()
    {
        require_memory(header_, sizeof(std::int32_t), name_);
        labels_.assign(header_.voxels(), 0);
    }

    std::int32_t above_threshold(double value)
    {
        not_numbers_ += std::isnan(value) ? 1 : 0;
        return value >= *threshold_ ? 1 : 0;
    }

    std::int32_t whole_label(double value, std::size_t voxel)
    {
        const double intercept = std::abs(header_.intercept);
        const double whole = std::nearbyint(value);
        const bool is_whole = imaging::is_whole_label(value, std::max(std::abs(value - header_.intercept), intercept));
        const bool fits = std::abs(whole) <= static_cast<double>(std::numeric_limits<std::int32_t>::max());
        if (!is_whole || !fits)
        {
            note(value, voxel, is_whole);
        }
        return is_whole && fits ? static_cast<std::int32_t>(whole) : 0;
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

    [[noreturn]] void refuse(std::string_view what, std::size_t bad, std::string_view expected) const
    {
        const auto width = static_cast<std::size_t>(header_.size[0]);
        const auto height = static_cast<std::size_t>(header_.size[1]);
        fail_reading(name_, fmt::format("{} of {} voxels {}", bad, header_.voxels(), what),
                     fmt::format("{:.9g} at voxel ({}, {}, {})", first_, first_voxel_ % width,
                                 first_voxel_ / width % height, first_voxel_ / (width * height)),
                     expected);
    }

    const VolumeHeader& header_;
    std::optional<double> threshold_;
    const std::string& name_;
    std::vector<std::int32_t> labels_;
    std::size_t not_whole_ = 0;
    std::size_t out_of_range_ = 0;
    std::size_t not_numbers_ = 0;
    double first_ = 0.0;
    std::size_t first_voxel_ = 0;
};

} // namespace

imaging::LabelVolume parse_labels(const VolumeBytes& bytes, const std::string& name, const VolumeChoice& choice)
{
    VolumeNumbers numbers(bytes, name, choice.coordinates);
    const VolumeHeader& header = numbers.header();
    LabelReader reader(header, choice.threshold, name);
    numbers.read(chosen_volume(header, choice.volume, name), 1,
                 [&](std::span<const double> piece, std::size_t first) { reader.take(piece, first); });
    imaging::LabelVolume image{header.size, header.frame, reader.finish(), header.notes};
    if (reader.not_numbers() > 0)
    {
        image.notes.push_back(fmt::format("{} of {} voxels are no numbers (NaN): taken as below the threshold of {:g}",
                                          reader.not_numbers(), header.voxels(), choice.threshold.value_or(0.0)));
    }
    return image;
}

imaging::LabelVolume read_labels(const std::filesystem::path& file, const VolumeChoice& choice)
{
    const VolumeFile files(file);
    return parse_labels(files.bytes(), file.string(), choice);
}

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_header.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/volumes/nifti_frame.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::formats
{

namespace
{

void read_size(const NiftiFields& fields, const std::string& name, VolumeHeader& header)
{
    const std::int64_t dimensions = fields.integer(fields.layout().dim);
    if (dimensions < 3 || dimensions > 7)
    {
        fail_reading(name, "not a volume", fmt::format("{} dimensions", dimensions), "3 (4 with a choice of volume)");
    }
    std::int64_t voxels = 1;
    for (std::int64_t k = 1; k <= dimensions; ++k)
    {
        const std::int64_t length = fields.integer(fields.layout().dim, static_cast<std::size_t>(k));
        add_axis(k, length, voxels, name);
        if (k <= 3)
        {
            header.size[k - 1] = length;
        }
        else
        {
            header.volumes *= length;
        }
    }
}

NumberType checked_type(const NiftiFields& fields, const std::string& name)
{
    using enum NumberType;
    const auto type = static_cast<NumberType>(fields.datatype());
    const auto known = {uint8, int16, int32, float32, float64, int8, uint16, uint32, int64, uint64};
    if (std::find(known.begin(), known.end(), type) == known.end())
    {
        fail_reading(name, "numbers of a kind that labels cannot have", fmt::format("datatype {}", fields.datatype()),
                     "8- to 64-bit integers (2, 4, 8, 256, 512, 768, 1024, 1280) or floats (16, 64)");
    }
    return type;
}

void read_scaling(const NiftiFields& fields, const std::string& name, VolumeHeader& header)
{
    const double slope = fields.real(fields.layout().scl_slope);
    const double intercept = fields.real(fields.layout().scl_inter);
    if (!std::isfinite(slope) || slope == 0.0) // none, as nibabel takes it
    {
        return;
    }
    if (!std::isfinite(intercept))
    {
        fail_reading(name, "scl_inter is not finite", fmt::format("{}", intercept), "a number");
    }
    header.slope = slope;
    header.intercept = intercept;
}

} // namespace

VolumeHeader read_nifti_header(std::string_view start, InflatingStream& stream, const std::string& name,
                               Coordinates coordinates)
{
    const NiftiFields fields(start, stream, name);
    const NiftiLayout& at = fields.layout();
    VolumeHeader header;
    header.big_endian = fields.big_endian();
    header.is_pair = fields.is_pair();
    read_size(fields, name, header);
    header.type = checked_type(fields, name);
    read_scaling(fields, name, header);
    const std::size_t least = header.is_pair ? 0 : at.size;
    const double offset = fields.vox_offset();
    if (!(offset >= static_cast<double>(least) && offset <= 1e9) || offset != std::floor(offset))
    {
        fail_reading(name, "absurd vox_offset", fmt::format("{:.9g}", offset),
                     header.is_pair ? "a byte of the image file"
                                    : fmt::format("a byte after the header of {}", at.size));
    }
    header.skip = static_cast<std::size_t>(offset) - least;
    header.frame = read_nifti_frame(fields, header.size, coordinates, header.notes);
    return header;
}

} // namespace corticle::formats

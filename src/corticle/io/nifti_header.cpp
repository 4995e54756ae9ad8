// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/nifti_header.hpp"

#include "corticle/io/format_error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle
{

namespace
{

constexpr std::int64_t most_voxels = std::int64_t{1} << 31;
constexpr double smallest_voxel = 0.01; // [mm]
constexpr double largest_voxel = 20.0;  // [mm]

/// The fields of a header of either kind and byte order.
class HeaderFields
{
  public:
    HeaderFields(InflatingStream& stream, const std::string& name) : name_(name)
    {
        const std::size_t there = stream.read(bytes_.data(), 4);
        if (there < 4 || !find_layout())
        {
            fail_reading(name, "not a NIfTI file", there < 4 ? fmt::format("{} bytes", there) : first_bytes(),
                         "a header of 348 (NIfTI-1) or 540 bytes (NIfTI-2)");
        }
        const std::size_t rest = stream.read(bytes_.data() + 4, layout_.size - 4);
        if (rest < layout_.size - 4)
        {
            fail_reading(name, "truncated in its header", fmt::format("{} bytes", rest + 4),
                         fmt::format("{}", layout_.size));
        }
        require_magic();
    }

    const NiftiLayout& layout() const { return layout_; }
    bool swapped() const { return swapped_; }

    /// Element k of an integer field; 64 bits in NIfTI-2 where `wide`.
    std::int64_t integer(std::size_t offset, std::size_t k = 0) const
    {
        return layout_.wide ? number_at<std::int64_t>(&bytes_[offset + 8 * k], swapped_)
                            : number_at<std::int16_t>(&bytes_[offset + 2 * k], swapped_);
    }
    double real(std::size_t offset, std::size_t k = 0) const
    {
        return layout_.wide ? number_at<double>(&bytes_[offset + 8 * k], swapped_)
                            : static_cast<double>(number_at<float>(&bytes_[offset + 4 * k], swapped_));
    }
    std::int64_t code(std::size_t offset) const
    {
        return layout_.wide ? number_at<std::int32_t>(&bytes_[offset], swapped_)
                            : number_at<std::int16_t>(&bytes_[offset], swapped_);
    }
    std::int64_t datatype() const { return number_at<std::int16_t>(&bytes_[layout_.datatype], swapped_); }
    std::int64_t units() const
    {
        return layout_.wide ? number_at<std::int32_t>(&bytes_[layout_.units], swapped_)
                            : static_cast<unsigned char>(bytes_[layout_.units]);
    }
    double vox_offset() const
    {
        return layout_.wide ? static_cast<double>(integer(layout_.vox_offset)) : real(layout_.vox_offset);
    }

  private:
    bool find_layout()
    {
        for (const bool swapped : {false, true})
        {
            const auto size = number_at<std::int32_t>(bytes_.data(), swapped);
            if (size == 348 || size == 540)
            {
                layout_ = size == 348 ? nifti1_layout : nifti2_layout;
                swapped_ = swapped;
                return true;
            }
        }
        return false;
    }

    std::string first_bytes() const
    {
        std::string text = "the bytes";
        for (int k = 0; k < 4; ++k)
        {
            text += fmt::format(" {:02x}", static_cast<unsigned>(static_cast<unsigned char>(bytes_[k])));
        }
        return text;
    }

    void require_magic() const
    {
        const std::string_view magic(bytes_.data() + layout_.magic, layout_.wide ? 8 : 4);
        const std::string_view single =
            layout_.wide ? std::string_view("n+2\0\r\n\032\n", 8) : std::string_view("n+1\0", 4);
        if (magic.substr(0, 3) == "ni1" || magic.substr(0, 3) == "ni2")
        {
            fail_reading(name_, "a pair of header and image files", magic.substr(0, 3),
                         "a single .nii or .nii.gz file");
        }
        if (magic != single)
        {
            fail_reading(name_, "wrong magic", fmt::format("\"{}\"", magic), layout_.wide ? "n+2" : "n+1");
        }
    }

    const std::string& name_;
    std::array<char, 540> bytes_{};
    NiftiLayout layout_{};
    bool swapped_ = false;
};

void read_size(const HeaderFields& fields, const std::string& name, NiftiHeader& header)
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
        if (length < 1 || length > most_voxels || (voxels *= length) > most_voxels)
        {
            fail_reading(name, fmt::format("absurd size along axis {}", k), fmt::format("{}", length),
                         "1 or more voxels, not above 2^31 in all");
        }
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

NiftiType checked_type(const HeaderFields& fields, const std::string& name)
{
    using enum NiftiType;
    const auto type = static_cast<NiftiType>(fields.datatype());
    const auto known = {uint8, int16, int32, float32, float64, int8, uint16, uint32, int64, uint64};
    if (std::find(known.begin(), known.end(), type) == known.end())
    {
        fail_reading(name, "numbers of a kind that labels cannot have", fmt::format("datatype {}", fields.datatype()),
                     "8- to 64-bit integers (2, 4, 8, 256, 512, 768, 1024, 1280) or floats (16, 64)");
    }
    return type;
}

/// nifti1.h, method 2: a rotation by a quaternion, whose first component follows from the others.
Mat3 quaternion_rotation(double b, double c, double d)
{
    const double a = std::sqrt(std::max(0.0, 1.0 - b * b - c * c - d * d));
    return {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
             {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
             {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c}}};
}

VoxelFrame qform_frame(const HeaderFields& fields, const std::string& name)
{
    const NiftiLayout& at = fields.layout();
    const auto [b, c, d] =
        std::array{fields.real(at.quaternion, 0), fields.real(at.quaternion, 1), fields.real(at.quaternion, 2)};
    constexpr double round_off = 1e-3; // of three floats
    if (!(b * b + c * c + d * d <= 1.0 + round_off))
    {
        fail_reading(name, "qform is no rotation", fmt::format("quaternion {:g}, {:g}, {:g}", b, c, d),
                     "a length of at most 1");
    }
    const double flip = fields.real(at.pixdim) == -1.0 ? -1.0 : 1.0;
    const Mat3 zooms =
        Mat3::diagonal(fields.real(at.pixdim, 1), fields.real(at.pixdim, 2), flip * fields.real(at.pixdim, 3));
    return {quaternion_rotation(b, c, d) * zooms,
            {fields.real(at.offset, 0), fields.real(at.offset, 1), fields.real(at.offset, 2)}};
}

VoxelFrame sform_frame(const HeaderFields& fields)
{
    VoxelFrame frame;
    for (int row = 0; row < 3; ++row)
    {
        const std::size_t first = 4 * static_cast<std::size_t>(row);
        for (int column = 0; column < 3; ++column)
        {
            frame.linear(row, column) = fields.real(fields.layout().sform, first + static_cast<std::size_t>(column));
        }
        frame.origin[row] = fields.real(fields.layout().sform, first + 3);
    }
    return frame;
}

VoxelFrame pixdim_frame(const HeaderFields& fields, const std::array<std::int64_t, 3>& size)
{
    const std::size_t at = fields.layout().pixdim;
    VoxelFrame frame;
    frame.linear = Mat3::diagonal(-fields.real(at, 1), fields.real(at, 2), fields.real(at, 3));
    frame.origin = -(frame.linear * (0.5 * Vec3{static_cast<double>(size[0] - 1), static_cast<double>(size[1] - 1),
                                                static_cast<double>(size[2] - 1)}));
    return frame;
}

double millimetres_of_unit(const HeaderFields& fields)
{
    const std::int64_t unit = fields.units() & 7;
    return unit == 1 ? 1000.0 : (unit == 3 ? 0.001 : 1.0);
}

void require_frame(const VoxelFrame& frame, const std::string& name)
{
    const Vec3 edges = voxel_edges(frame);
    for (int axis = 0; axis < 3; ++axis)
    {
        if (!(edges[axis] >= smallest_voxel && edges[axis] <= largest_voxel))
        {
            fail_reading(name, fmt::format("absurd voxel size along axis {}", axis + 1),
                         fmt::format("{:g} mm", edges[axis]),
                         fmt::format("{:g} to {:g} mm", smallest_voxel, largest_voxel));
        }
    }
    constexpr double flattest = 1e-3; // volume of a voxel over that of one with right angles
    const double volume = std::abs(determinant(frame.linear));
    if (!(volume >= flattest * edges.x * edges.y * edges.z))
    {
        fail_reading(name, "singular affine", fmt::format("voxels of {:g} mm³", volume),
                     "three edges that do not lie in a plane");
    }
    constexpr double farthest = 1e7; // [mm]
    if (!(norm(frame.origin) <= farthest))
    {
        fail_reading(name, "absurd place of the first voxel",
                     fmt::format("({:g}, {:g}, {:g}) mm", frame.origin.x, frame.origin.y, frame.origin.z),
                     "less than 10 km away");
    }
}

void read_scaling(const HeaderFields& fields, const std::string& name, NiftiHeader& header)
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

std::size_t size_of(NiftiType type)
{
    using enum NiftiType;
    switch (type)
    {
    case uint8:
    case int8:
        return 1;
    case int16:
    case uint16:
        return 2;
    case int32:
    case uint32:
    case float32:
        return 4;
    default:
        return 8;
    }
}

NiftiHeader read_nifti_header(InflatingStream& stream, const std::string& name)
{
    const HeaderFields fields(stream, name);
    const NiftiLayout& at = fields.layout();
    NiftiHeader header;
    header.swapped = fields.swapped();
    read_size(fields, name, header);
    header.type = checked_type(fields, name);
    read_scaling(fields, name, header);
    const double offset = fields.vox_offset();
    if (!(offset >= static_cast<double>(at.size) && offset <= 1e9) || offset != std::floor(offset))
    {
        fail_reading(name, "absurd vox_offset", fmt::format("{:g}", offset),
                     fmt::format("a byte after the header of {}", at.size));
    }
    header.skip = static_cast<std::size_t>(offset) - at.size;
    header.frame = fields.code(at.sform_code) > 0   ? sform_frame(fields)
                   : fields.code(at.qform_code) > 0 ? qform_frame(fields, name)
                                                    : pixdim_frame(fields, header.size);
    const double millimetres = millimetres_of_unit(fields);
    header.frame.linear = millimetres * header.frame.linear;
    header.frame.origin *= millimetres;
    require_frame(header.frame, name);
    return header;
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_frame.hpp"

#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::formats
{

namespace
{

using Notes = std::vector<std::string>;

/// Sizes of a voxel: nifti1.h knows no negative ones (the flip of the third axis is pixdim[0]); nibabel, too, takes
/// their absolute values.
Vec3 voxel_sizes(const NiftiFields& fields, Notes& notes)
{
    Vec3 sizes;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double size = fields.real(fields.layout().pixdim, static_cast<std::size_t>(axis) + 1);
        if (size < 0.0)
        {
            notes.push_back(
                fmt::format("pixdim[{}] of the header is {:.9g}: taken as {:.9g}, a size", axis + 1, size, -size));
        }
        sizes[axis] = std::abs(size);
    }
    return sizes;
}

/// Whether the third axis is turned over (pixdim[0], "qfac"): -1 for yes, 1 and 0 for no. The reference code and
/// nibabel differ over other negative numbers.
double third_axis_sense(const NiftiFields& fields, Notes& notes)
{
    const double sense = fields.real(fields.layout().pixdim);
    if (!(sense >= 0.0 || sense == -1.0))
    {
        fail_reading(fields.file(), "pixdim[0] does not say which way the third axis of the qform runs",
                     fmt::format("{:.9g}", sense), "1 or -1");
    }
    if (sense != -1.0 && sense != 0.0 && sense != 1.0)
    {
        notes.push_back(fmt::format("pixdim[0] of the header is {:.9g}: taken as 1", sense));
    }
    return sense == -1.0 ? -1.0 : 1.0;
}

/// nifti1.h, method 2: a rotation by a quaternion, whose first component follows from the others. Where round-off makes
/// them longer than 1 that component vanishes and they are brought to length 1, as by the reference code.
Mat3 quaternion_rotation(Vec3 bcd)
{
    const double rest = 1.0 - squared_norm(bcd);
    constexpr double vanishing = 1e-7; // that of the reference code
    const double a = rest < vanishing ? 0.0 : std::sqrt(rest);
    bcd = rest < vanishing ? normalized(bcd) : bcd;
    const auto [b, c, d] = std::array{bcd.x, bcd.y, bcd.z};
    return {{{a * a + b * b - c * c - d * d, 2 * (b * c + a * d), 2 * (b * d - a * c)},
             {2 * (b * c - a * d), a * a + c * c - b * b - d * d, 2 * (c * d + a * b)},
             {2 * (b * d + a * c), 2 * (c * d - a * b), a * a + d * d - b * b - c * c}}};
}

imaging::VoxelFrame qform_frame(const NiftiFields& fields, Notes& notes)
{
    const NiftiLayout& at = fields.layout();
    const Vec3 bcd{fields.real(at.quaternion, 0), fields.real(at.quaternion, 1), fields.real(at.quaternion, 2)};
    constexpr double round_off = 1e-3; // of three floats
    constexpr double single_precision = 1e-6;
    if (!(squared_norm(bcd) <= 1.0 + round_off))
    {
        fail_reading(fields.file(), "qform is no rotation",
                     fmt::format("quaternion {:.9g}, {:.9g}, {:.9g}", bcd.x, bcd.y, bcd.z), "a length of at most 1");
    }
    if (squared_norm(bcd) > 1.0 + single_precision)
    {
        notes.push_back(fmt::format("the quaternion of the qform has length {:.9g}: brought to 1", norm(bcd)));
    }
    Vec3 sizes = voxel_sizes(fields, notes);
    sizes.z *= third_axis_sense(fields, notes);
    return {quaternion_rotation(bcd) * Mat3::diagonal(sizes.x, sizes.y, sizes.z),
            {fields.real(at.offset, 0), fields.real(at.offset, 1), fields.real(at.offset, 2)}};
}

imaging::VoxelFrame sform_frame(const NiftiFields& fields)
{
    imaging::VoxelFrame frame;
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

imaging::VoxelFrame pixdim_frame(const NiftiFields& fields, const std::array<std::int64_t, 3>& size, Notes& notes)
{
    const Vec3 sizes = voxel_sizes(fields, notes);
    imaging::VoxelFrame frame;
    frame.linear = Mat3::diagonal(-sizes.x, sizes.y, sizes.z);
    frame.origin = -(frame.linear * (0.5 * Vec3{static_cast<double>(size[0] - 1), static_cast<double>(size[1] - 1),
                                                static_cast<double>(size[2] - 1)}));
    notes.emplace_back("the header has neither sform nor qform: the image is centred and its first axis taken to run "
                       "to the left, so left and right are a guess");
    return frame;
}

bool is_zero(const Mat3& matrix)
{
    return squared_norm(matrix.column[0]) + squared_norm(matrix.column[1]) + squared_norm(matrix.column[2]) == 0.0;
}

/// A frame and the field of the header that it comes from.
struct NamedFrame
{
    imaging::VoxelFrame frame;
    std::string field;
};

NamedFrame chosen_frame(const NiftiFields& fields, const std::array<std::int64_t, 3>& size, Notes& notes)
{
    const NiftiLayout& at = fields.layout();
    const std::int64_t sform_code = fields.code(at.sform_code);
    const std::int64_t qform_code = fields.code(at.qform_code);
    if (sform_code > 0)
    {
        const imaging::VoxelFrame sform = sform_frame(fields);
        if (!is_zero(sform.linear))
        {
            // A rotation mirrors nothing, so the sense of the third axis decides for the qform.
            const bool qform_mirrors = fields.real(at.pixdim) == -1.0;
            if (qform_code > 0 && qform_mirrors != (determinant(sform.linear) < 0.0))
            {
                notes.emplace_back("sform and qform disagree about left and right, one mirrors the other: the sform is "
                                   "taken");
            }
            return {sform, fmt::format("sform (code {})", sform_code)};
        }
        if (qform_code <= 0)
        {
            fail_reading(fields.file(), fmt::format("sform (code {}) is a matrix of zeros", sform_code),
                         "no qform in its place", "the place of the voxels in one of them");
        }
        notes.push_back(fmt::format("the sform (code {}) is a matrix of zeros: the qform is taken", sform_code));
    }
    return qform_code > 0 ? NamedFrame{qform_frame(fields, notes), fmt::format("qform (code {})", qform_code)}
                          : NamedFrame{pixdim_frame(fields, size, notes), "pixdim"};
}

/// Millimetres in the unit of length, and how to speak of it.
struct LengthUnit
{
    double millimetres = 1.0;
    std::string remark; ///< for messages; empty for millimetres
};

LengthUnit length_unit(const NiftiFields& fields, Coordinates coordinates, Notes& notes)
{
    const std::int64_t code = fields.units() & 7;
    if (code == 0 || code == 2)
    {
        return {};
    }
    if (code > 3)
    {
        notes.push_back(fmt::format("xyzt_units of the header has an unknown unit of length, code {}: taken as "
                                    "millimetres",
                                    code));
        return {};
    }
    const std::string name = code == 1 ? "metres" : "micrometres";
    if (coordinates == Coordinates::file)
    {
        notes.push_back(
            fmt::format("xyzt_units of the header says {}: taken as millimetres, since coordinates = file", name));
        return {};
    }
    const double factor = code == 1 ? 1000.0 : 0.001;
    notes.push_back(fmt::format("xyzt_units of the header says {}: lengths were multiplied by {:g} (coordinates = file "
                                "takes them as millimetres)",
                                name, factor));
    return {factor, fmt::format(" (xyzt_units says {})", name)};
}

} // namespace

imaging::VoxelFrame read_nifti_frame(const NiftiFields& fields, const std::array<std::int64_t, 3>& size,
                                     Coordinates coordinates, std::vector<std::string>& notes)
{
    NamedFrame named = chosen_frame(fields, size, notes);
    const LengthUnit unit = length_unit(fields, coordinates, notes);
    named.frame.linear = unit.millimetres * named.frame.linear;
    named.frame.origin *= unit.millimetres;
    require_frame(named.frame, fields.file(), named.field, unit.remark);
    return named.frame;
}

} // namespace corticle::formats

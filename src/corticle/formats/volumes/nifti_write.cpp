// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_write.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/volumes/nifti_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace corticle::formats
{

namespace
{

constexpr std::int16_t scanner_frame = 1; ///< NIFTI_XFORM_SCANNER_ANAT
constexpr char millimetres = 2;           ///< NIFTI_UNITS_MM
constexpr std::size_t data_offset = 352;  ///< of a single file without extensions

/// A header in this machine's byte order.
class HeaderBytes
{
  public:
    template <class T>
    void put(std::size_t offset, T value, std::size_t k = 0)
    {
        std::memcpy(&bytes[offset + k * sizeof(T)], &value, sizeof(T));
    }
    std::string bytes = std::string(data_offset, '\0');
};

struct Quaternion
{
    double a, b, c, d;
};

/// Of a rotation (nifti1.h, nifti_mat44_to_quatern); the largest component is found first, for precision. a >= 0.
Quaternion quaternion_of(const Mat3& r)
{
    const std::array<double, 4> squares{1 + r(0, 0) + r(1, 1) + r(2, 2), 1 + r(0, 0) - r(1, 1) - r(2, 2),
                                        1 - r(0, 0) + r(1, 1) - r(2, 2), 1 - r(0, 0) - r(1, 1) + r(2, 2)};
    const auto largest = std::max_element(squares.begin(), squares.end()) - squares.begin();
    const double s = 0.5 * std::sqrt(squares[largest]);
    const double f = 0.25 / s;
    const double x = r(2, 1) - r(1, 2);
    const double y = r(0, 2) - r(2, 0);
    const double z = r(1, 0) - r(0, 1);
    const double xy = r(0, 1) + r(1, 0);
    const double xz = r(0, 2) + r(2, 0);
    const double yz = r(1, 2) + r(2, 1);
    Quaternion q{};
    switch (largest)
    {
    case 0:
        q = {s, f * x, f * y, f * z};
        break;
    case 1:
        q = {f * x, s, f * xy, f * xz};
        break;
    case 2:
        q = {f * y, f * xy, s, f * yz};
        break;
    default:
        q = {f * z, f * xz, f * yz, s};
    }
    return q.a < 0.0 ? Quaternion{-q.a, -q.b, -q.c, -q.d} : q;
}

/// Edges of unit length, the third turned over where the frame is left-handed; nothing where they are not at right
/// angles.
std::optional<Mat3> rotation_of(const imaging::VoxelFrame& frame, double handedness)
{
    const Vec3 edges = imaging::voxel_edges(frame);
    Mat3 r = frame.linear * Mat3::diagonal(1.0 / edges.x, 1.0 / edges.y, handedness / edges.z);
    constexpr double round_off = 1e-6;
    const Mat3 skew = transpose(r) * r - Mat3::identity();
    return contract(skew, skew) <= round_off * round_off ? std::optional(r) : std::nullopt;
}

void put_frame(const imaging::VoxelFrame& frame, HeaderBytes& header)
{
    const NiftiLayout& at = nifti1_layout;
    const double handedness = determinant(frame.linear) < 0.0 ? -1.0 : 1.0;
    const Vec3 edges = imaging::voxel_edges(frame);
    header.put(at.pixdim, static_cast<float>(handedness));
    for (int axis = 0; axis < 3; ++axis)
    {
        header.put(at.pixdim, static_cast<float>(edges[axis]), static_cast<std::size_t>(axis) + 1);
        header.put(at.offset, static_cast<float>(frame.origin[axis]), static_cast<std::size_t>(axis));
    }
    if (const std::optional<Mat3> rotation = rotation_of(frame, handedness))
    {
        const Quaternion q = quaternion_of(*rotation);
        header.put(at.qform_code, scanner_frame);
        header.put(at.quaternion, static_cast<float>(q.b), 0);
        header.put(at.quaternion, static_cast<float>(q.c), 1);
        header.put(at.quaternion, static_cast<float>(q.d), 2);
    }
    header.put(at.sform_code, scanner_frame);
    for (int row = 0; row < 3; ++row)
    {
        const std::size_t first = 4 * static_cast<std::size_t>(row);
        for (int column = 0; column < 3; ++column)
        {
            header.put(at.sform, static_cast<float>(frame.linear(row, column)),
                       first + static_cast<std::size_t>(column));
        }
        header.put(at.sform, static_cast<float>(frame.origin[row]), first + 3);
    }
}

template <class Number>
void append_labels(const imaging::LabelVolume& image, NumberType type, HeaderBytes& header)
{
    constexpr std::size_t bitpix = 72;
    header.put(nifti1_layout.datatype, static_cast<std::int16_t>(type));
    header.put(bitpix, static_cast<std::int16_t>(8 * sizeof(Number)));
    const std::size_t begin = header.bytes.size();
    header.bytes.resize(begin + image.labels.size() * sizeof(Number));
    for (std::size_t k = 0; k < image.labels.size(); ++k)
    {
        header.put(begin, static_cast<Number>(image.labels[k]), k);
    }
}

std::string nifti1_bytes(const imaging::LabelVolume& image)
{
    const NiftiLayout& at = nifti1_layout;
    HeaderBytes header;
    header.put(0, static_cast<std::int32_t>(at.size));
    header.put(at.dim, std::int16_t{3});
    for (std::size_t k = 1; k < 8; ++k)
    {
        header.put(at.dim, static_cast<std::int16_t>(k <= 3 ? image.size[k - 1] : 1), k);
    }
    header.put(at.vox_offset, static_cast<float>(data_offset));
    header.put(at.scl_slope, 1.0F);
    header.put(at.units, millimetres);
    header.bytes.replace(at.magic, 3, "n+1");
    put_frame(image.frame, header);
    const auto [low, high] = std::minmax_element(image.labels.begin(), image.labels.end());
    if (*low >= 0 && *high <= std::numeric_limits<std::uint8_t>::max())
    {
        append_labels<std::uint8_t>(image, NumberType::uint8, header);
    }
    else if (*low >= std::numeric_limits<std::int16_t>::min() && *high <= std::numeric_limits<std::int16_t>::max())
    {
        append_labels<std::int16_t>(image, NumberType::int16, header);
    }
    else
    {
        append_labels<std::int32_t>(image, NumberType::int32, header);
    }
    return std::move(header.bytes);
}

} // namespace

void write_nifti(const std::filesystem::path& file, const imaging::LabelVolume& image)
{
    const std::string name = file.filename().string();
    const bool compressed = name.ends_with(".nii.gz");
    if (!compressed && !name.ends_with(".nii"))
    {
        throw InputError(fmt::format("{}: a label image is written as .nii or .nii.gz", file.string()));
    }
    for (const std::int64_t length : image.size)
    {
        if (length < 1 || length > std::numeric_limits<std::int16_t>::max())
        {
            throw InputError(fmt::format("{}: {} voxels along an axis; expected 1 to 32767", file.string(), length));
        }
    }
    const std::string bytes = nifti1_bytes(image);
    write_text_atomically(file, compressed ? gzip(bytes) : bytes);
}

} // namespace corticle::formats

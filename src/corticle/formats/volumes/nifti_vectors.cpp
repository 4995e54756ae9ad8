// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/nifti_vectors.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/volumes/nifti_header.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::formats
{

namespace
{

constexpr std::int64_t components = 3;

double number_of(const NiftiHeader& header, const char* bytes)
{
    using enum NiftiType;
    switch (header.type)
    {
    case uint8:
        return number_at<std::uint8_t>(bytes, header.swapped);
    case int16:
        return number_at<std::int16_t>(bytes, header.swapped);
    case int32:
        return number_at<std::int32_t>(bytes, header.swapped);
    case float32:
        return static_cast<double>(number_at<float>(bytes, header.swapped));
    case float64:
        return number_at<double>(bytes, header.swapped);
    case int8:
        return number_at<std::int8_t>(bytes, header.swapped);
    case uint16:
        return number_at<std::uint16_t>(bytes, header.swapped);
    case uint32:
        return number_at<std::uint32_t>(bytes, header.swapped);
    case int64:
        return static_cast<double>(number_at<std::int64_t>(bytes, header.swapped));
    case uint64:
        return static_cast<double>(number_at<std::uint64_t>(bytes, header.swapped));
    }
    return 0.0;
}

/// All numbers of the image, volume by volume.
std::string data_of(InflatingStream& stream, const NiftiHeader& header, std::size_t voxels, const std::string& name)
{
    const std::size_t wanted = header.skip + static_cast<std::size_t>(components) * voxels * size_of(header.type);
    if (wanted > stream.most_left())
    {
        fail_reading(name, "data shorter than announced", fmt::format("at most {} bytes", stream.most_left()),
                     fmt::format("{}", wanted));
    }
    std::string data(wanted, '\0');
    for (std::size_t done = 0; done < wanted;)
    {
        const std::size_t there = stream.read(data.data() + done, wanted - done);
        if (there == 0)
        {
            fail_reading(name, "data shorter than announced", fmt::format("{} bytes", done), fmt::format("{}", wanted));
        }
        done += there;
    }
    return data;
}

} // namespace

const Vec3* VectorVolume::at(const Vec3& index) const
{
    std::int64_t place = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
        const double k = std::round(index[axis]);
        if (!(k >= 0.0 && k < static_cast<double>(size[static_cast<std::size_t>(axis)])))
        {
            return nullptr;
        }
        place = place * size[static_cast<std::size_t>(axis)] + static_cast<std::int64_t>(k);
    }
    return &vectors[static_cast<std::size_t>(place)];
}

VectorVolume read_nifti_vectors(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    const std::string name = file.string();
    InflatingStream stream(bytes, name);
    const NiftiHeader header = read_nifti_header(stream, name, Coordinates::scanner);
    if (header.volumes != components)
    {
        fail_reading(name, "not an image of vectors", fmt::format("{} volumes", header.volumes), "three, x, y and z");
    }
    VectorVolume image;
    image.size = header.size;
    image.frame = header.frame;
    const auto voxels = static_cast<std::size_t>(header.size[0] * header.size[1] * header.size[2]);
    const std::string data = data_of(stream, header, voxels, name);
    image.vectors.resize(voxels);
    const std::size_t width = size_of(header.type);
    for (std::size_t k = 0; k < static_cast<std::size_t>(components) * voxels; ++k)
    {
        const double value = header.slope * number_of(header, data.data() + header.skip + k * width) + header.intercept;
        if (!std::isfinite(value))
        {
            fail_reading(name, fmt::format("voxel {} holds no number", k % voxels), fmt::format("{}", value),
                         "three finite numbers");
        }
        image.vectors[k % voxels][static_cast<int>(k / voxels)] = value;
    }
    return image;
}

} // namespace corticle::formats

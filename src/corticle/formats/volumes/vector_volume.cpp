// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/volumes/vector_volume.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/volumes/volume_numbers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::formats
{

namespace
{

constexpr std::int64_t components = 3;

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

VectorVolume read_vectors(const std::filesystem::path& file)
{
    const VolumeFile files(file);
    const std::string name = file.string();
    VolumeNumbers numbers(files.bytes(), name, Coordinates::scanner);
    const VolumeHeader& header = numbers.header();
    if (header.volumes != components)
    {
        fail_reading(name, "not an image of vectors", fmt::format("{} volumes", header.volumes), "three, x, y and z");
    }
    require_memory(header, sizeof(Vec3), name);
    VectorVolume image{header.size, header.frame, {}};
    const std::size_t voxels = header.voxels();
    numbers.read(0, components,
                 [&](std::span<const double> piece, std::size_t first)
                 {
                     for (std::size_t k = 0; k < piece.size(); ++k)
                     {
                         const std::size_t voxel = (first + k) % voxels;
                         if (!std::isfinite(piece[k]))
                         {
                             fail_reading(name, fmt::format("voxel {} holds no number", voxel),
                                          fmt::format("{}", piece[k]), "three finite numbers");
                         }
                         if (piece[k] != 0.0 && image.vectors.empty())
                         {
                             image.vectors.resize(voxels); // not before: zeros take few bytes of a file
                         }
                         if (!image.vectors.empty())
                         {
                             image.vectors[voxel][static_cast<int>((first + k) / voxels)] = piece[k];
                         }
                     }
                 });
    if (image.vectors.empty())
    {
        fail_reading(name, "an image of no vector", fmt::format("{} voxels of zeros", voxels), "some that are not 0");
    }
    return image;
}

} // namespace corticle::formats

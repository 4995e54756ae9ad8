// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/gifti.hpp"
#include "corticle/formats/surfaces/surface_formats.hpp"
#include "corticle/formats/surfaces/volume_geometry.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::formats
{

namespace
{

constexpr const char* scanner_space = "NIFTI_XFORM_SCANNER_ANAT";
constexpr const char* unknown_space = "NIFTI_XFORM_UNKNOWN";

const GiftiArray& only_array(const GiftiFile& file, const char* intent, const SurfaceBuilder& surface)
{
    const auto has_intent = [&](const GiftiArray& array) { return array.intent == intent; };
    const auto count = std::ranges::count_if(file.arrays, has_intent);
    if (count != 1)
    {
        fail_reading(surface.file(), "not one GIFTI surface", fmt::format("{} arrays of intent {}", count, intent),
                     "one");
    }
    const GiftiArray& array = *std::ranges::find_if(file.arrays, has_intent);
    if (array.dimensions.size() != 2 || array.dimensions[1] != 3)
    {
        fail_reading(surface.file(), fmt::format("bad array of intent {}", intent),
                     fmt::format("dimensions {}", fmt::join(array.dimensions, " x ")), "N x 3");
    }
    return array;
}

/// The map that FreeSurfer's metadata describe; nothing without them.
std::optional<AffineMap> freesurfer_map(const GiftiArray& points, const SurfaceBuilder& surface)
{
    VolumeGeometry volume;
    const auto take = [&](char axis, Vec3& direction)
    {
        int found = 0;
        for (int k = 0; k < 3; ++k)
        {
            const auto entry = points.metadata.find(fmt::format("VolGeom{}_{}", axis, "RAS"[k]));
            found += entry != points.metadata.end() && to_number(entry->second, direction[k]) ? 1 : 0;
        }
        return found == 3;
    };
    if (!take('C', volume.c_ras))
    {
        return std::nullopt;
    }
    take('X', volume.x_ras);
    take('Y', volume.y_ras);
    take('Z', volume.z_ras);
    const std::optional<AffineMap> map = tkras_to_scanner(volume);
    if (!map)
    {
        fail_reading(surface.file(), "bad volume geometry in the metadata", "axes that do not span space",
                     "three unit vectors and a centre");
    }
    return map;
}

AffineMap map_of(const GiftiTransform& transform, const SurfaceBuilder& surface)
{
    AffineMap map;
    for (int row = 0; row < 3; ++row)
    {
        for (int column = 0; column < 3; ++column)
        {
            map.linear(row, column) =
                transform.matrix[4 * static_cast<std::size_t>(row) + static_cast<std::size_t>(column)];
        }
        map.shift[row] = transform.matrix[4 * static_cast<std::size_t>(row) + 3];
    }
    const double scale = std::abs(determinant(map.linear));
    if (!(scale > 0.0) || !std::isfinite(scale))
    {
        fail_reading(surface.file(), fmt::format("bad matrix from {} to scanner space", transform.data_space),
                     fmt::format("determinant {}", scale), "a matrix that can be inverted");
    }
    return map;
}

/// From the coordinates of the file to scanner space: nothing to do for coordinates in scanner space; the matrix that
/// leads there, where there is one; else FreeSurfer's volume geometry, unless the file says that the coordinates are in
/// a space of another name already; else the coordinates are taken as they are.
AffineMap to_scanner(const GiftiArray& points, SurfaceBuilder& surface)
{
    const auto& transforms = points.transforms;
    if (std::ranges::any_of(transforms, [](const GiftiTransform& t) { return t.data_space == scanner_space; }))
    {
        return {};
    }
    const auto to_there = std::ranges::find(transforms, scanner_space, &GiftiTransform::transformed_space);
    if (to_there != transforms.end())
    {
        return surface.chosen_map(map_of(*to_there, surface),
                                  fmt::format("the matrix of the file from {} to scanner space", to_there->data_space));
    }
    const auto named = std::ranges::find_if(transforms, [](const GiftiTransform& t)
                                            { return !t.data_space.empty() && t.data_space != unknown_space; });
    if (named != transforms.end())
    {
        surface.note(fmt::format("points are in {} by the file's word, which does not say how to get from there to the "
                                 "scanner: taken as they are",
                                 named->data_space));
        return {};
    }
    return surface.chosen_map(freesurfer_map(points, surface).value_or(AffineMap{}),
                              "the volume geometry in the metadata of the file");
}

} // namespace

void parse_gifti_surface(std::string_view bytes, SurfaceBuilder& surface)
{
    const GiftiFile file = parse_gifti(bytes, surface.file());
    const GiftiArray& points = only_array(file, "NIFTI_INTENT_POINTSET", surface);
    const GiftiArray& triangles = only_array(file, "NIFTI_INTENT_TRIANGLE", surface);
    const AffineMap map = to_scanner(points, surface);
    surface.reserve(points.values.size() / 3, triangles.values.size() / 3);
    for (std::size_t i = 0; i < points.values.size(); i += 3)
    {
        surface.add_vertex(map({points.values[i], points.values[i + 1], points.values[i + 2]}));
    }
    constexpr double most = 2147483647.0;
    for (std::size_t i = 0; i < triangles.values.size(); i += 3)
    {
        std::array<std::int64_t, 3> corners{};
        for (std::size_t k = 0; k < 3; ++k)
        {
            const double corner = triangles.values[i + k];
            corners[k] = corner >= 0.0 && corner <= most ? static_cast<std::int64_t>(corner) : -1;
        }
        if (map.mirrors())
        {
            std::swap(corners[1], corners[2]);
        }
        surface.add_polygon(corners);
    }
}

} // namespace corticle::formats

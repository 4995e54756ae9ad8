// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/ventricle_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/imaging/marching_tetrahedra.hpp"
#include "corticle/imaging/mask_cleanup.hpp"
#include "corticle/imaging/smoothing.hpp"
#include "corticle/prepare/label_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace corticle::prepare
{

namespace
{

constexpr std::size_t near_nodes = 14; ///< of which four are chosen
constexpr double reach_in_spacings = 2.5;
constexpr float level = 0.5F;
constexpr double clearance = 0.1; ///< of the surface from voxel centres, in voxels: see marching_tetrahedra

using Four = std::array<std::int32_t, 4>;
using Weights = std::array<double, 4>;

/// Barycentric coordinates of a point; all 0 where the tetrahedron is flat.
Weights barycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, double least_volume)
{
    const double whole = dot(b - a, cross(c - a, d - a));
    if (std::abs(whole) < 6.0 * least_volume)
    {
        return {};
    }
    const double of_b = dot(p - a, cross(c - a, d - a)) / whole;
    const double of_c = dot(b - a, cross(p - a, d - a)) / whole;
    const double of_d = dot(b - a, cross(c - a, p - a)) / whole;
    return {1.0 - of_b - of_c - of_d, of_b, of_c, of_d};
}

/// The nodes nearest to a point, nearest first.
std::vector<std::int32_t> nearest_nodes(const Vec3& p, std::span<const Vec3> nodes, double reach)
{
    std::vector<std::int32_t> near;
    for (std::int32_t i = 0; i < std::ssize(nodes); ++i)
    {
        if (squared_norm(nodes[static_cast<std::size_t>(i)] - p) < reach * reach)
        {
            near.push_back(i);
        }
    }
    std::ranges::sort(near, {}, [&](std::int32_t i) { return squared_norm(nodes[static_cast<std::size_t>(i)] - p); });
    near.resize(std::min(near.size(), near_nodes));
    return near;
}

/// The four nodes in whose tetrahedron a point lies deepest, and its coordinates there.
std::pair<Four, Weights> tie(const Vec3& p, std::span<const Vec3> nodes, double spacing)
{
    const std::vector<std::int32_t> near = nearest_nodes(p, nodes, reach_in_spacings * spacing);
    const double least_volume = 0.01 * spacing * spacing * spacing;
    std::pair<Four, Weights> best{{0, 0, 0, 0}, {}};
    double deepest = -1.0;
    const auto at = [&](std::size_t k) -> const Vec3& { return nodes[static_cast<std::size_t>(near[k])]; };
    for (std::size_t i = 0; i < near.size(); ++i)
    {
        for (std::size_t j = i + 1; j < near.size(); ++j)
        {
            for (std::size_t k = j + 1; k < near.size(); ++k)
            {
                for (std::size_t m = k + 1; m < near.size(); ++m)
                {
                    const Weights weights = barycentric(p, at(i), at(j), at(k), at(m), least_volume);
                    if (const double least = std::ranges::min(weights); weights != Weights{} && least > deepest)
                    {
                        deepest = least;
                        best = {{near[i], near[j], near[k], near[m]}, weights};
                    }
                }
            }
        }
    }
    return best;
}

/// The surface of the labelled ventricles, in as many parts as they have.
TriangleMesh labelled_surface(const PreparationOptions& options, double spacing)
{
    const GeometryOptions& geometry = options.geometry;
    const auto& labels = options.labels[static_cast<std::size_t>(material::TissueKind::ventricle)];
    const imaging::LabelVolume image = read_body_labels(geometry);
    const double smoothing = 0.5 * spacing;
    const imaging::GridMask selected = imaging::select_labels(image, labels, 5.0 * smoothing);
    std::vector<float> values(selected.mask.begin(), selected.mask.end());
    imaging::smooth_gaussian(selected.grid, smoothing, values);
    TriangleMesh surface = imaging::marching_tetrahedra(selected.grid, values, level, clearance);
    if (surface.triangles.empty())
    {
        throw InputError(
            fmt::format("boundary.ventricle_pressure: the ventricles (tissue.labels.ventricle) are thinner "
                        "than the spacing of {:.4g} mm; expected more particles",
                        spacing));
    }
    return surface;
}

} // namespace

boundary::TiedSurface tied_surface(const TriangleMesh& surface, std::span<const Vec3> nodes, double spacing)
{
    boundary::TiedSurface tied;
    tied.triangles = surface.triangles;
    tied.nodes.resize(surface.vertices.size());
    tied.weights.resize(surface.vertices.size());
    parallel_for(std::ssize(surface.vertices), [&](std::int64_t k)
                 { std::tie(tied.nodes[k], tied.weights[k]) = tie(surface.vertices[k], nodes, spacing); });
    for (std::size_t k = 0; k < tied.weights.size(); ++k)
    {
        if (tied.weights[k] == Weights{})
        {
            const Vec3& p = surface.vertices[k];
            throw InputError(fmt::format("boundary.ventricle_pressure: the wall of the ventricles at ({:.4g}, {:.4g}, "
                                         "{:.4g}) mm is not within the body",
                                         p.x, p.y, p.z));
        }
    }
    return tied;
}

boundary::TiedSurface ventricle_surface(const PreparationOptions& options, const model::Model& model)
{
    if (options.boundary.ventricle_pressure == 0.0)
    {
        return {};
    }
    const double spacing = model.cloud.largest_spacing();
    return tied_surface(labelled_surface(options, spacing), model.cloud.positions, spacing);
}

} // namespace corticle::prepare

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/from_tets.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/cells.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/cloud/quality.hpp"
#include "corticle/cloud/thinning.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::cloud
{

namespace
{

/// Distance of inner particles from the surface, in spacings: the second where the first leaves too few nodes.
constexpr std::array<double, 2> inner_depths{0.5, 0.3};

/// Nodes inside a surface and at least `depth` from it [mm], in ascending order.
std::vector<std::int32_t> inner_nodes(const TetMesh& mesh, const geometry::SurfaceTree& tree, double depth)
{
    std::vector<std::int32_t> nodes;
    parallel_list(std::ssize(mesh.vertices), nodes,
                  [&](std::int64_t begin, std::int64_t end, std::vector<std::int32_t>& found)
                  {
                      for (std::int64_t i = begin; i < end; ++i)
                      {
                          const Vec3& p = mesh.vertices[i];
                          if (tree.closest_within(p, depth).triangle < 0 && tree.winding_number(p) == 1)
                          {
                              found.push_back(static_cast<std::int32_t>(i));
                          }
                      }
                  });
    return nodes;
}

/// Inner nodes that become particles beside those on the surface.
std::vector<Vec3> chosen_nodes(const TetMesh& mesh, const TriangleMesh& surface, std::int64_t count, double spacing,
                               const TetCloudOptions& options)
{
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    std::vector<std::int32_t> inner;
    for (const double depth : inner_depths)
    {
        inner = inner_nodes(mesh, tree, depth * spacing);
        if (std::ssize(inner) >= count)
        {
            break;
        }
    }
    const std::vector<double> node_volume = node_volumes(mesh);
    std::vector<Vec3> points;
    std::vector<double> volumes;
    for (const std::int32_t node : inner)
    {
        points.push_back(mesh.vertices[node]);
        volumes.push_back(node_volume[node]);
    }
    count = std::min(count, std::ssize(points));
    if (count == 0)
    {
        return {};
    }
    const std::vector<std::int32_t> kept =
        options.thinning == Thinning::random
            ? thin_random_by_volume(points, volumes, count, options.seed)
            : thin_uniform_beside(surface.vertices, points, volumes, count, options.seed);
    std::vector<Vec3> chosen;
    chosen.reserve(kept.size());
    for (const std::int32_t k : kept)
    {
        chosen.push_back(points[k]);
    }
    return chosen;
}

TetCloud every_node(const TetMesh& mesh)
{
    TetBoundary boundary = boundary_of(mesh);
    const std::vector<double> node_volume = node_volumes(mesh);
    std::vector<Vec3> points = boundary.surface.vertices;
    const std::vector<Vec3> node_centroid = node_centroids(mesh);
    Cells cells;
    std::vector<std::int32_t> point_of(mesh.vertices.size(), -1);
    for (const std::int32_t node : boundary.nodes)
    {
        point_of[node] = static_cast<std::int32_t>(cells.volumes.size());
        cells.volumes.push_back(node_volume[node]);
        cells.centroids.push_back(node_centroid[node]);
    }
    for (std::size_t node = 0; node < mesh.vertices.size(); ++node)
    {
        if (point_of[node] < 0)
        {
            point_of[node] = static_cast<std::int32_t>(points.size());
            points.push_back(mesh.vertices[node]);
            cells.volumes.push_back(node_volume[node]);
            cells.centroids.push_back(node_centroid[node]);
        }
    }
    TetCloud result;
    std::vector<std::int32_t> particle_of;
    result.cloud = ordered_cloud(points, cells, boundary.surface, &particle_of);
    result.surface = std::move(boundary.surface);
    for (const Tet& tet : mesh.tets)
    {
        const auto corner = [&](int a) { return particle_of[point_of[tet[a]]]; };
        result.tets.push_back({corner(0), corner(1), corner(2), corner(3)});
    }
    return result;
}

TetCloud thinned(const TetMesh& mesh, std::int64_t wanted, const TetCloudOptions& options)
{
    const TriangleMesh boundary = boundary_of(mesh).surface;
    const double spacing = spacing_for_particles(enclosed_volume(boundary.vertices, boundary.triangles), wanted);
    TetCloud result;
    result.surface = geometry::remesh_isotropic(boundary, edge_per_spacing * spacing, &result.remesh);
    const std::int64_t inside = std::max<std::int64_t>(wanted - std::ssize(result.surface.vertices), 0);
    const std::vector<Vec3> chosen = chosen_nodes(mesh, result.surface, inside, spacing, options);
    std::vector<Vec3> points = result.surface.vertices;
    points.insert(points.end(), chosen.begin(), chosen.end());
    result.cloud = ordered_cloud(points, cells_of(result.surface, points, spacing), result.surface);
    if (std::ssize(chosen) < inside)
    {
        result.warnings.push_back(
            fmt::format("tet mesh: only {} of its {} nodes lie far enough inside for a spacing of "
                        "{:.4g} mm; {} particles instead of {}; a finer mesh is needed for more",
                        chosen.size(), mesh.vertices.size(), spacing, points.size(), wanted));
    }
    return result;
}

void warn_of_irregularity(TetCloud& result)
{
    constexpr double closest = 0.5; // spacings, below which pairs distort the gradient
    constexpr double largest = 3.0; // mean volumes, above which neighbours are few
    const CloudQuality quality = measure_quality(result.cloud);
    if (quality.closest_pair_spacings < closest)
    {
        result.warnings.push_back(
            fmt::format("tet mesh: two particles are {:.2g} spacings apart; expected at least {}; "
                        "uniform thinning to fewer particles parts them",
                        quality.closest_pair_spacings, closest));
    }
    if (quality.largest_volume > largest * quality.mean_volume)
    {
        result.warnings.push_back(fmt::format(
            "tet mesh: the largest particle has {:.2g} times the mean volume; expected at most {}; particles "
            "are sparse around it",
            quality.largest_volume / quality.mean_volume, largest));
    }
}

} // namespace

TetCloud cloud_from_tets(const TetMesh& mesh, const TetCloudOptions& options)
{
    require_tets(mesh);
    require_finite("nodes of the tet mesh", mesh.vertices);
    const std::int64_t nodes = std::ssize(mesh.vertices);
    const std::int64_t wanted = options.particles.value_or(nodes);
    if (wanted < 1 || wanted > nodes)
    {
        throw InputError(
            fmt::format("tet mesh: {} particles; expected 1 to {}, the number of its nodes", wanted, nodes));
    }
    TetCloud result = wanted == nodes ? every_node(mesh) : thinned(mesh, wanted, options);
    warn_of_irregularity(result);
    return result;
}

} // namespace corticle::cloud

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/drawn_boundary.hpp"

#include "corticle/imaging/taubin_smoothing.hpp"

#include <algorithm>

namespace corticle::view
{

namespace
{

constexpr int sweeps = 10;

double mean_edge(const TriangleMesh& surface)
{
    double sum = 0.0;
    for (const Triangle& t : surface.triangles)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            sum += norm(surface.vertices[t[k]] - surface.vertices[t[(k + 1) % 3]]);
        }
    }
    return sum / (3.0 * static_cast<double>(surface.triangles.size()));
}

} // namespace

std::vector<Vec3> drawn_boundary(const formats::SurfaceFile& surface)
{
    const std::vector<Vec3>& outer = surface.mesh.vertices;
    const auto found = std::ranges::find(surface.fields, std::string("cortex_boundary"),
                                         &std::pair<std::string, std::vector<double>>::first);
    if (found == surface.fields.end() || found->second.size() != 3 * outer.size() || surface.mesh.triangles.empty())
    {
        return {};
    }
    TriangleMesh inner{{}, surface.mesh.triangles};
    for (std::size_t i = 0; i < found->second.size(); i += 3)
    {
        inner.vertices.push_back({found->second[i], found->second[i + 1], found->second[i + 2]});
    }
    std::vector<Vec3> boundary = inner.vertices;
    imaging::smooth_taubin(inner, sweeps);
    const double whole = mean_edge(surface.mesh); // thickness from which on a point is free to move
    for (std::size_t v = 0; v < boundary.size(); ++v)
    {
        const double share = std::min(norm(boundary[v] - outer[v]) / whole, 1.0);
        if (share > 0.0)
        {
            boundary[v] += share * (inner.vertices[v] - boundary[v]);
        }
    }
    return boundary;
}

} // namespace corticle::view

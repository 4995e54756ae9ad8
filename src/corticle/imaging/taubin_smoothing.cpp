// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/taubin_smoothing.hpp"

#include "corticle/mesh/sizes.hpp"

namespace corticle::imaging
{

namespace
{

/// On a closed surface each neighbour comes up twice, in the two triangles of an edge.
void move_to_mean(TriangleMesh& surface, const std::vector<double>& uses, double share)
{
    std::vector<Vec3> sum(surface.vertices.size());
    for (const Triangle& t : surface.triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            sum[t[k]] += surface.vertices[t[(k + 1) % 3]] + surface.vertices[t[(k + 2) % 3]];
        }
    }
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        surface.vertices[v] += share * (sum[v] / (2.0 * uses[v]) - surface.vertices[v]);
    }
}

} // namespace

void smooth_taubin(TriangleMesh& surface, int sweeps)
{
    require_vertices(surface);
    std::vector<double> uses(surface.vertices.size(), 0.0);
    for (const Triangle& t : surface.triangles)
    {
        for (const std::int32_t vertex : t)
        {
            uses[vertex] += 1.0;
        }
    }
    for (int sweep = 0; sweep < sweeps; ++sweep)
    {
        move_to_mean(surface, uses, 0.5);
        move_to_mean(surface, uses, -0.53);
    }
}

} // namespace corticle::imaging

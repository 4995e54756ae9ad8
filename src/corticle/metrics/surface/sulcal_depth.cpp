// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/sulcal_depth.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <algorithm>
#include <limits>
#include <queue>

namespace corticle::metrics
{

namespace
{

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double clearance_per_edge = 1e-3; ///< how far off the surface the straight way starts and ends

double mean_edge(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    double sum = 0.0;
    for (const Triangle& t : triangles)
    {
        sum += norm(vertices[t[1]] - vertices[t[0]]) + norm(vertices[t[2]] - vertices[t[1]]) +
               norm(vertices[t[0]] - vertices[t[2]]);
    }
    return triangles.empty() ? 0.0 : sum / (3.0 * static_cast<double>(triangles.size()));
}

/// Distance at c of a plane front that passes a and b at the distances T_a and T_b and comes from their side; else the
/// way along an edge.
double front_arrival(const Vec3& a, const Vec3& b, const Vec3& c, double T_a, double T_b)
{
    const Vec3 p = a - c;
    const Vec3 q = b - c;
    const double along_edge = std::min(T_a + norm(p), T_b + norm(q));
    const double pp = dot(p, p);
    const double pq = dot(p, q);
    const double qq = dot(q, q);
    const double det = pp * qq - pq * pq;
    if (!(det > 0.0) || T_a == infinity || T_b == infinity)
    {
        return along_edge;
    }
    // With d the unit gradient and T_k - T = d . (x_k - c):  (T_a - T, T_b - T) G^-1 (T_a - T, T_b - T)^T = 1, where G
    // is the matrix of the dot products.
    const double one = (qq - 2.0 * pq + pp) / det;
    const double mixed = (qq * T_a - pq * (T_a + T_b) + pp * T_b) / det;
    const double squared = (qq * T_a * T_a - 2.0 * pq * T_a * T_b + pp * T_b * T_b) / det;
    const double root = mixed * mixed - one * (squared - 1.0);
    if (root < 0.0)
    {
        return along_edge;
    }
    const double T = (mixed + std::sqrt(root)) / one;
    const double from_a = qq * (T_a - T) - pq * (T_b - T);
    const double from_b = pp * (T_b - T) - pq * (T_a - T);
    const bool comes_through_the_edge = from_a < 0.0 && from_b < 0.0;
    return comes_through_the_edge ? std::min(T, along_edge) : along_edge;
}

/// Is the straight way from just off a vertex to just before a point free of the surface?
bool sees(const geometry::SurfaceTree& surface, const Vec3& vertex, const Vec3& normal, const Vec3& goal,
          double clearance)
{
    const Vec3 start = vertex + clearance * normal;
    const Vec3 way = goal - start;
    const double length = norm(way);
    return length <= clearance || !surface.segment_crosses(start, goal - (clearance / length) * way);
}

} // namespace

std::vector<double> marched_distance(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                     std::vector<double> start)
{
    const VertexLists around = incident_triangles(vertices.size(), triangles);
    std::vector<double> distance = std::move(start);
    std::vector<bool> final(vertices.size(), false);
    using Entry = std::pair<double, std::int32_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> front;
    for (std::size_t v = 0; v < vertices.size(); ++v)
    {
        if (distance[v] < infinity)
        {
            front.emplace(distance[v], static_cast<std::int32_t>(v));
        }
    }
    while (!front.empty())
    {
        const auto [reached, v] = front.top();
        front.pop();
        if (final[v])
        {
            continue;
        }
        final[v] = true;
        for (const std::int32_t k : around.of(v))
        {
            for (int corner = 0; corner < 3; ++corner)
            {
                const std::int32_t c = triangles[k][corner];
                if (final[c])
                {
                    continue;
                }
                const std::int32_t next = triangles[k][(corner + 1) % 3];
                const std::int32_t other = next == v ? triangles[k][(corner + 2) % 3] : next;
                const double T_other = final[other] ? distance[other] : infinity;
                const double arrival = front_arrival(vertices[v], vertices[other], vertices[c], reached, T_other);
                if (arrival < distance[c])
                {
                    distance[c] = arrival;
                    front.emplace(arrival, c);
                }
            }
        }
    }
    return distance;
}

std::vector<double> sulcal_depth(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                 const geometry::SurfaceTree& outer)
{
    const geometry::SurfaceTree surface(vertices, triangles);
    const std::vector<Vec3> normals = vertex_normals(vertices, triangles);
    const double clearance = clearance_per_edge * mean_edge(vertices, triangles);
    std::vector<double> straight(vertices.size());
    std::vector<double> start(vertices.size());
    parallel_for(std::ssize(vertices),
                 [&](std::int64_t v)
                 {
                     const geometry::SurfacePoint nearest = outer.closest(vertices[v]);
                     straight[v] = std::max(0.0, -outer.signed_distance(vertices[v], nearest));
                     const bool free = straight[v] <= clearance ||
                                       sees(surface, vertices[v], normals[v], nearest.position, clearance);
                     start[v] = free ? straight[v] : infinity;
                 });
    std::vector<double> depth = marched_distance(vertices, triangles, std::move(start));
    for (std::size_t v = 0; v < depth.size(); ++v)
    {
        depth[v] = depth[v] < infinity ? depth[v] : straight[v];
    }
    return depth;
}

} // namespace corticle::metrics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/curvature.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <Eigen/Cholesky>

#include <numbers>

namespace corticle::metrics
{

namespace
{

constexpr int unknowns = 5;              ///< of h(u, v) = a u²/2 + b u v + c v²/2 + d u + e v
constexpr double least_weight = 0.01;    ///< of a neighbour whose normal is turned away: across a crease
constexpr double regularization = 1e-10; ///< over the largest diagonal entry: keeps a poor ring solvable
using Row = Eigen::Vector<double, unknowns>;

struct NormalEquations
{
    Eigen::Matrix<double, unknowns, unknowns> matrix = Eigen::Matrix<double, unknowns, unknowns>::Zero();
    Row right = Row::Zero();

    void add(const Row& terms, double height, double weight)
    {
        matrix += weight * terms * terms.transpose();
        right += weight * height * terms;
    }

    Row solution() const
    {
        auto regular = matrix;
        regular.diagonal().array() += regularization * matrix.diagonal().maxCoeff();
        return regular.ldlt().solve(right);
    }
};

struct MeanAndGaussian
{
    double mean = 0.0;
    double gaussian = 0.0;
};

/// Of the graph of the quadric at the origin, the height counted along the outward normal.
MeanAndGaussian graph_curvature(const Row& q)
{
    const double a = q[0];
    const double b = q[1];
    const double c = q[2];
    const double d = q[3];
    const double e = q[4];
    const double squared_slope = 1.0 + d * d + e * e;
    const double mean =
        ((1.0 + d * d) * c - 2.0 * d * e * b + (1.0 + e * e) * a) / (2.0 * std::pow(squared_slope, 1.5));
    return {-mean, (a * c - b * b) / (squared_slope * squared_slope)};
}

/// Neighbours and their neighbours, without the vertex itself.
void two_rings(const VertexLists& adjacent, std::int32_t vertex, std::vector<std::int32_t>& rings)
{
    rings.clear();
    for (const std::int32_t near : adjacent.of(vertex))
    {
        rings.push_back(near);
        for (const std::int32_t far : adjacent.of(near))
        {
            rings.push_back(far);
        }
    }
    std::sort(rings.begin(), rings.end());
    rings.erase(std::unique(rings.begin(), rings.end()), rings.end());
    std::erase(rings, vertex);
}

MeanAndGaussian fit(std::span<const Vec3> vertices, std::span<const Vec3> normals, std::int32_t vertex,
                    std::span<const std::int32_t> rings)
{
    const Vec3 n = normals[vertex];
    const Vec3 along = std::abs(n.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    const Vec3 e1 = normalized(cross(n, along));
    const Vec3 e2 = cross(n, e1);
    double scale = 0.0;
    for (const std::int32_t j : rings)
    {
        scale += norm(vertices[j] - vertices[vertex]);
    }
    if (scale == 0.0)
    {
        return {};
    }
    scale /= static_cast<double>(rings.size());
    NormalEquations equations;
    for (const std::int32_t j : rings)
    {
        const Vec3 d = (vertices[j] - vertices[vertex]) / scale;
        const double u = dot(d, e1);
        const double v = dot(d, e2);
        equations.add(Row{0.5 * u * u, u * v, 0.5 * v * v, u, v}, dot(d, n),
                      std::max(least_weight, dot(n, normals[j])));
    }
    const MeanAndGaussian scaled = graph_curvature(equations.solution());
    return {scaled.mean / scale, scaled.gaussian / (scale * scale)};
}

} // namespace

Curvature vertex_curvature(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    const VertexLists adjacent = adjacent_vertices(vertices.size(), triangles);
    const std::vector<Vec3> normals = vertex_normals(vertices, triangles);
    const std::size_t count = vertices.size();
    Curvature curvature{std::vector<double>(count), std::vector<double>(count), std::vector<double>(count),
                        std::vector<double>(count)};
    parallel_blocks(static_cast<std::int64_t>(count),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        std::vector<std::int32_t> rings;
                        for (std::int64_t i = begin; i < end; ++i)
                        {
                            two_rings(adjacent, static_cast<std::int32_t>(i), rings);
                            const auto [H, K] = fit(vertices, normals, static_cast<std::int32_t>(i), rings);
                            const double half_difference = std::sqrt(std::max(0.0, H * H - K)); // (k1 - k2) / 2
                            curvature.mean[i] = H;
                            curvature.gaussian[i] = K;
                            curvature.shape_index[i] = 2.0 / std::numbers::pi * std::atan2(H, half_difference);
                            curvature.curvedness[i] = std::hypot(H, half_difference);
                        }
                    });
    return curvature;
}

} // namespace corticle::metrics

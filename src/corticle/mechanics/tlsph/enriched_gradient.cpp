// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/enriched_gradient.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/simd.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace corticle::tlsph
{

namespace
{

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Matrix63 = Eigen::Matrix<double, 6, 3>;
using Reach = EnrichedGradients::Reach;

// Tikhonov regularisation of the fit, relative to its linear part. A quadratic along the normal is hardly resolved by
// one-sided supports: left to itself it makes noise, while those across the normal do not (docs/theory/tlsph.md).
constexpr double along_normal = 0.05;
constexpr double across_normal = 1e-3;
constexpr double agreement = 0.5; ///< least length of the mean of the normals in reach: below, they face each other

/// Normals of the surface at its particles, weighted by area; zero elsewhere.
std::vector<Vec3> surface_normals(const Cloud& cloud)
{
    std::vector<Vec3> normals(cloud.positions.size());
    for (const Triangle& triangle : cloud.surface_triangles)
    {
        const auto corner = [&](int c) { return cloud.surface_particles[triangle[c]]; };
        const Vec3& a = cloud.positions[corner(0)];
        const Vec3 area = cross(cloud.positions[corner(1)] - a, cloud.positions[corner(2)] - a);
        for (int c = 0; c < 3; ++c)
        {
            normals[corner(c)] += area;
        }
    }
    std::ranges::transform(normals, normals.begin(), normalized);
    return normals;
}

/// Normals of the particles near the surface, those of their neighbours on it in the mean; zero where there are none,
/// or where they face each other.
std::vector<Vec3> normals_near(const PairBlocks& pairs, const std::vector<Vec3>& on_surface)
{
    std::vector<Vec3> normals = on_surface;
    parallel_for(std::ssize(normals),
                 [&](std::int64_t i)
                 {
                     if (squared_norm(on_surface[i]) > 0.0)
                     {
                         return;
                     }
                     Vec3 sum;
                     double weights = 0.0;
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         const Vec3& normal = on_surface[pairs.neighbor(i, k)];
                         const double w = pairs.weight[k];
                         sum += w * normal;
                         weights += w * squared_norm(normal);
                     }
                     normals[i] = norm(sum) > agreement * weights ? normalized(sum) : Vec3{};
                 });
    return normals;
}

/// What the particle's gradient knows: p_ij = (X_ij, (n_i . X_ij) X_ij / s).
struct Fit
{
    Matrix6 shape = Matrix6::Zero(); ///< sum_j w_ij p_ij p_ij^T
    Vec3 moment;

    void add(double w, const Vec3& X, double height, double support)
    {
        Eigen::Matrix<double, 6, 1> p;
        p << X.x, X.y, X.z, height / support * X.x, height / support * X.y, height / support * X.z;
        shape += w * p * p.transpose();
        moment += w * height * X;
    }
};

Mat3 matrix_of(const Eigen::Matrix3d& m)
{
    Mat3 result;
    for (int row = 0; row < 3; ++row)
    {
        for (int col = 0; col < 3; ++col)
        {
            result(row, col) = m(row, col);
        }
    }
    return result;
}

/// B and Q such that the gradient is exact for affine motion and, but for the regularisation, for (n . X) X.
/// @param offset  of the centroid of the cell from the particle: the gradient is that at the centroid
/// @param thin    whether the support reaches through the body
void solve(const Fit& fit, const Vec3& offset, double support, bool thin, EnrichedGradient& gradient)
{
    const Eigen::Vector3d n{gradient.normal.x, gradient.normal.y, gradient.normal.z};
    const Eigen::Vector3d c{offset.x, offset.y, offset.z};
    const Eigen::Matrix3d along = n * n.transpose();
    const double across = thin ? along_normal : across_normal;
    const double scale = fit.shape.topLeftCorner<3, 3>().trace() / 3.0;
    Matrix6 shape = fit.shape;
    shape.bottomRightCorner<3, 3>() += scale * (across * (Eigen::Matrix3d::Identity() - along) + along_normal * along);
    Matrix63 slope; // of the six functions at the centroid
    slope.topRows<3>().setIdentity();
    slope.bottomRows<3>() = (c * n.transpose() + n.dot(c) * Eigen::Matrix3d::Identity()) / support;
    const Matrix63 solution = shape.ldlt().solve(slope);
    gradient.B = matrix_of(solution.topRows<3>().transpose());
    gradient.Q = matrix_of(solution.bottomRows<3>().transpose() / support);
    gradient.moment = fit.moment;
}

/// @param on_surface  normals of the particles on the surface, zero elsewhere
EnrichedGradient enriched(const Cloud& cloud, const PairBlocks& pairs, double support, std::int64_t i,
                          const Vec3& normal, const std::vector<Vec3>& on_surface)
{
    EnrichedGradient gradient;
    gradient.normal = normal;
    Fit fit;
    bool thin = false;
    for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
    {
        const std::int32_t j = pairs.neighbor(i, k);
        const Vec3 X = cloud.positions[j] - cloud.positions[i];
        fit.add(static_cast<double>(pairs.weight[k]), X, dot(normal, X), support);
        thin = thin || dot(on_surface[i], on_surface[j]) < -0.5;
    }
    solve(fit, cloud.centroids[i] - cloud.positions[i], support, thin, gradient);
    return gradient;
}

std::vector<Reach> reaches(const PairBlocks& pairs, const std::vector<Vec3>& normals)
{
    std::vector<Reach> reach(normals.size(), Reach::none);
    const auto is_enriched = [&](std::int64_t i) { return squared_norm(normals[i]) > 0.0; };
    parallel_for(std::ssize(reach),
                 [&](std::int64_t i)
                 {
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1] && reach[i] == Reach::none; ++k)
                     {
                         reach[i] = is_enriched(pairs.neighbor(i, k)) ? Reach::neighbors : Reach::none;
                     }
                     reach[i] = is_enriched(i) ? Reach::itself : reach[i];
                 });
    return reach;
}

/// Moves the pairs whose neighbour is enriched to the front of those of their particle, in their order.
void put_enriched_first(const std::vector<Reach>& reach, PairBlocks& pairs)
{
    parallel_for(std::ssize(reach),
                 [&](std::int64_t i)
                 {
                     std::vector<std::pair<std::uint16_t, float>> others;
                     std::int64_t end = pairs.begin[i];
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         if (reach[pairs.neighbor(i, k)] == Reach::itself)
                         {
                             pairs.place[end] = pairs.place[k];
                             pairs.weight[end++] = pairs.weight[k];
                         }
                         else
                         {
                             others.emplace_back(pairs.place[k], pairs.weight[k]);
                         }
                     }
                     pairs.enriched_end[i] = end;
                     for (const auto& [place, weight] : others)
                     {
                         pairs.place[end] = place;
                         pairs.weight[end++] = weight;
                     }
                 });
}

} // namespace

Reach EnrichedGradients::farthest(std::int64_t begin, std::int64_t end) const
{
    return *std::max_element(reach.begin() + begin, reach.begin() + end);
}

EnrichedGradients enrich_gradients(const Cloud& cloud, const LargeVector<Mat3>& correction,
                                   std::span<const double> supports, PairBlocks& pairs)
{
    const std::vector<Vec3> on_surface = surface_normals(cloud);
    const std::vector<Vec3> normals = normals_near(pairs, on_surface);
    const std::int64_t count = std::ssize(normals);
    EnrichedGradients result;
    result.reach = reaches(pairs, normals);
    result.at.assign(normals.size(), -1);
    std::int32_t places = 0;
    for (std::int64_t first = 0; first < count; first += wide_lanes)
    {
        const std::int64_t end = std::min(first + wide_lanes, count);
        if (result.farthest(first, end) == Reach::itself)
        {
            for (std::int64_t i = first; i < end; ++i)
            {
                result.at[i] = places++;
            }
        }
    }
    result.gradient.resize(places);
    parallel_for(count,
                 [&](std::int64_t i)
                 {
                     if (result.at[i] >= 0)
                     {
                         result.gradient[result.at[i]] =
                             result.reach[i] == Reach::itself
                                 ? enriched(cloud, pairs, supports[i], i, normals[i], on_surface)
                                 : EnrichedGradient{correction[i], {}, {}, {}};
                     }
                 });
    put_enriched_first(result.reach, pairs);
    return result;
}

} // namespace corticle::tlsph

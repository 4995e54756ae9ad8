// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/enriched_gradient.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/tlsph/fit.hpp"

#include <Eigen/Cholesky>

#include <algorithm>
#include <utility>

namespace corticle::tlsph
{

namespace
{

using Matrix9 = Eigen::Matrix<double, quadratic_functions, quadratic_functions>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector9 = Eigen::Matrix<double, quadratic_functions, 1>;
using Vector6 = Eigen::Matrix<double, 6, 1>;
using Reach = EnrichedGradients::Reach;

// Tikhonov regularisation of the fit, relative to its linear part. A quadratic along the normal is hardly resolved by
// one-sided supports: left to itself it makes noise, while the two across the normal do not. Those tangential to the
// surface cost the zero-energy control its hold on a surface that crumples (docs/decisions/enriched-gradient.md).
constexpr double along_normal = 0.05;
constexpr double across_normal = 1e-3;
constexpr double tangential = 0.5;
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

/// Products xx, xy, xz, yy, yz, zz.
Vector6 products(const Vec3& v)
{
    return {v.x * v.x, v.x * v.y, v.x * v.z, v.y * v.y, v.y * v.z, v.z * v.z};
}

/// Sum over the neighbours of what the fit needs: p_ij holds X_ij, and its products over the support s.
struct Shape
{
    Matrix9 matrix = Matrix9::Zero(); ///< sum_j w_ij p_ij p_ij^T
    Vector6 second_moment = Vector6::Zero();
    bool thin = false; ///< whether the support reaches through the body
};

/// @param on_surface  normals of the particles on the surface, zero elsewhere
Shape shape_of(const Cloud& cloud, const PairBlocks& pairs, double support, std::int64_t i,
               const std::vector<Vec3>& on_surface)
{
    Shape shape;
    for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
    {
        const std::int32_t j = pairs.neighbor(i, k);
        const auto w = static_cast<double>(pairs.weight[k]);
        const Vec3 X = cloud.positions[j] - cloud.positions[i];
        Vector9 p;
        const Vector6 squares = products(X);
        p << X.x, X.y, X.z, squares / support;
        shape.matrix += w * p * p.transpose();
        shape.second_moment += w * squares;
        shape.thin = shape.thin || dot(on_surface[i], on_surface[j]) < -0.5;
    }
    return shape;
}

/// The regularisation of the products, relative to the linear part. They make a function X . Y X with symmetric Y, of
/// which Y_nn is along the normal, Y_tn is across it, and the rest is tangential.
Matrix6 regularisation(const Vec3& normal, bool thin)
{
    const Vec3& n = normal;
    const Vector6 norm_of_Y{1.0, 0.5, 0.5, 1.0, 0.5, 1.0};
    Eigen::Matrix<double, 3, 6> Y_n;                 // of the products' coefficients
    Y_n << n.x, 0.5 * n.y, 0.5 * n.z, 0.0, 0.0, 0.0, //
        0.0, 0.5 * n.x, 0.0, n.y, 0.5 * n.z, 0.0,    //
        0.0, 0.0, 0.5 * n.x, 0.0, 0.5 * n.y, n.z;
    const Matrix6 all = norm_of_Y.asDiagonal();
    const Matrix6 with_normal = Y_n.transpose() * Y_n; // |Y_nn|² + |Y_tn|²
    const Matrix6 along = products(normal) * products(normal).transpose();
    return thin ? Matrix6(along_normal * all)
                : Matrix6(tangential * (all - 2.0 * with_normal + along) + 2.0 * across_normal * (with_normal - along) +
                          along_normal * along);
}

/// The inverse of a shape matrix, regularised, in terms of X_ij and its products.
Matrix9 inverse_of(const Shape& shape, double support, const Vec3& normal)
{
    const double scale = shape.matrix.topLeftCorner<3, 3>().trace() / 3.0;
    Matrix9 matrix = shape.matrix;
    matrix.bottomRightCorner<6, 6>() += scale * regularisation(normal, shape.thin);
    Vector9 units;
    units << 1.0, 1.0, 1.0, Vector6::Constant(1.0 / support);
    return units.asDiagonal() * matrix.ldlt().solve(Matrix9(units.asDiagonal()));
}

/// The fit of one particle, as QuadraticFits holds it.
struct ParticleFit
{
    Matrix9 inverse = Matrix9::Zero();
    Vector6 second_moment = Vector6::Zero();
    Vec3 at;
};

/// @param on_surface  normals of the particles on the surface, zero elsewhere
ParticleFit quadratic_fit(const Cloud& cloud, const PairBlocks& pairs, double support, std::int64_t i,
                          const Vec3& normal, const std::vector<Vec3>& on_surface)
{
    const Shape shape = shape_of(cloud, pairs, support, i, on_surface);
    return {inverse_of(shape, support, normal), shape.second_moment, cloud.centroids[i] - cloud.positions[i]};
}

/// @param correction  L_i
ParticleFit linear_fit(const Mat3& correction)
{
    ParticleFit fit;
    for (int row = 0; row < linear_functions; ++row)
    {
        for (int column = 0; column < linear_functions; ++column)
        {
            fit.inverse(row, column) = correction(row, column);
        }
    }
    return fit;
}

void put(const ParticleFit& fit, int lane, QuadraticFits& fits)
{
    int place = 0;
    for (int row = 0; row < quadratic_functions; ++row)
    {
        for (int column = row; column < quadratic_functions; ++column)
        {
            at_lane(fits.inverse[place++], lane) = fit.inverse(row, column);
        }
    }
    for (int k = 0; k < 6; ++k)
    {
        at_lane(fits.second_moment[k], lane) = fit.second_moment[k];
    }
    for (int axis = 0; axis < 3; ++axis)
    {
        at_lane(fits.at[axis], lane) = fit.at[axis];
    }
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
    result.group.assign(static_cast<std::size_t>(block_count(count, wide_lanes)), -1);
    std::int32_t groups = 0;
    for (std::int64_t first = 0; first < count; first += wide_lanes)
    {
        if (result.farthest(first, std::min(first + wide_lanes, count)) == Reach::itself)
        {
            result.group[first / wide_lanes] = groups++;
        }
    }
    result.fits.resize(groups);
    parallel_for(std::ssize(result.group),
                 [&](std::int64_t number)
                 {
                     if (result.group[number] < 0)
                     {
                         return;
                     }
                     const WideGroup group{number * wide_lanes, std::min(wide_lanes, count - number * wide_lanes)};
                     for (int lane = 0; lane < wide_lanes; ++lane)
                     {
                         const std::int64_t i = group.at(lane);
                         put(result.reach[i] == Reach::itself
                                 ? quadratic_fit(cloud, pairs, supports[i], i, normals[i], on_surface)
                                 : linear_fit(correction[i]),
                             lane, result.fits[result.group[number]]);
                     }
                 });
    put_enriched_first(result.reach, pairs);
    return result;
}

} // namespace corticle::tlsph

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/neighbors.hpp"
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/mechanics/tlsph/solver.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <map>

// A free square plate in which growth differs through the thickness, in linear elasticity: what the gradients make of
// bending, against exact curvatures.

namespace corticle::test
{

inline constexpr double plate_growth = 1e-3; ///< small: the answer is linear in it

/// The boundary of a box about the origin, one unit square of it after another, cut along alternating diagonals.
inline TriangleMesh unit_squares(const std::array<int, 3>& size)
{
    TriangleMesh mesh;
    std::map<std::array<int, 3>, std::int32_t> vertex_at;
    const auto vertex = [&](const std::array<int, 3>& k)
    {
        const auto [entry, is_new] = vertex_at.try_emplace(k, static_cast<std::int32_t>(mesh.vertices.size()));
        if (is_new)
        {
            mesh.vertices.push_back({k[0] - 0.5 * size[0], k[1] - 0.5 * size[1], k[2] - 0.5 * size[2]});
        }
        return entry->second;
    };
    for (int axis = 0; axis < 3; ++axis)
    {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const int side : {0, size[axis]})
        {
            for (int a = 0; a < size[u]; ++a)
            {
                for (int b = 0; b < size[v]; ++b)
                {
                    const auto corner = [&](int i, int j)
                    {
                        std::array<int, 3> k{};
                        k[axis] = side;
                        k[u] = a + (side > 0 ? i : j); // counter-clockwise seen from outside
                        k[v] = b + (side > 0 ? j : i);
                        return vertex(k);
                    };
                    const std::array<std::int32_t, 4> q{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    const int first = (a + b) % 2;
                    mesh.triangles.push_back({q[first], q[first + 1], q[first + 2]});
                    mesh.triangles.push_back({q[first], q[first + 2], q[(first + 3) % 4]});
                }
            }
        }
    }
    return mesh;
}

/// A plate of spacing 1 and eight times as wide as thick: particles of a cubic lattice, moved at random but for those
/// on an edge, those of a face within it.
struct Plate
{
    explicit Plate(int spacings) : thickness(spacings)
    {
        const int width = 8 * spacings;
        TriangleMesh surface = unit_squares({width, width, spacings});
        std::vector<Vec3> points = surface.vertices;
        for (int i = 1; i < width; ++i)
        {
            for (int j = 1; j < width; ++j)
            {
                for (int k = 1; k < spacings; ++k)
                {
                    points.push_back({i - 0.5 * width, j - 0.5 * width, k - 0.5 * spacings});
                }
            }
        }
        constexpr double jitter = 0.2;
        for (std::size_t k = 0; k < points.size(); ++k)
        {
            Vec3 move = jitter * random_vector(1, k);
            if (k < surface.vertices.size())
            {
                const bool on_face = std::abs(points[k].x) < 0.5 * width && std::abs(points[k].y) < 0.5 * width;
                move = on_face ? Vec3{move.x, move.y, 0.0} : Vec3{};
                surface.vertices[k] += move;
            }
            points[k] += move;
        }
        constexpr double lines = 12.0;
        cloud = cloud::ordered_cloud(points, cloud::cells_of(surface, points, 1.0, lines), surface);
        cloud.spacing = 1.0;
        const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
        const tlsph::TlsphOptions options;
        particles = tlsph::make_particles(cloud, cloud::find_neighbors(cloud, tree, options.support), options);
        const std::size_t count = cloud.positions.size();
        tissue.options.bulk_modulus = 5.0;
        tissue.options.barrier_J = 0.0;
        tissue.options.mu_cortex = tissue.options.mu_white = 1.0;
        tissue.options.alpha_t = plate_growth;
        tissue.options.alpha_white = 0.0;
        tissue.volume = cloud.volumes;
        tissue.depth.assign(count, 1.0);
        tissue.normal.assign(count, Vec3{0, 0, 1});
        tissue.regional_rate.assign(count, 1.0);
        tissue.theta.assign(count, 1.0);
    }

    double thickness;
    Cloud cloud;
    tlsph::Particles particles;
    OwnTissue tissue;
};

using Displacement = Eigen::Matrix<double, 3, Eigen::Dynamic>;

/// Forces of displacements, by central differences: minus the stiffness matrix times them.
inline Displacement linear_forces(tlsph::TlsphSolver& solver, const Plate& plate, const Displacement& u)
{
    const auto count = plate.cloud.positions.size();
    const auto forces_at = [&](double step)
    {
        std::vector<Vec3> x = plate.cloud.positions;
        for (std::size_t i = 0; i < count; ++i)
        {
            x[i] += step * Vec3{u(0, i), u(1, i), u(2, i)};
        }
        std::vector<Vec3> forces(count);
        solver.evaluate(x, 0.0, forces);
        return forces;
    };
    const double step = 1e-4 / u.cwiseAbs().maxCoeff();
    const std::vector<Vec3> plus = forces_at(step);
    const std::vector<Vec3> minus = forces_at(-step);
    Displacement result(3, count);
    for (std::size_t i = 0; i < count; ++i)
    {
        const Vec3 f = (plus[i] - minus[i]) / (2.0 * step);
        result.col(i) << f.x, f.y, f.z;
    }
    return result;
}

/// Curvature about both axes, by least squares of w = c + a x + b y + k (x² + y²) / 2 over the middle of the plate.
inline double fitted_curvature(const Plate& plate, const Displacement& u)
{
    const double reach = 0.3 * 8.0 * plate.thickness;
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < plate.cloud.positions.size(); ++i)
    {
        const Vec3& X = plate.cloud.positions[i];
        const double r2 = X.x * X.x + X.y * X.y;
        if (r2 < reach * reach)
        {
            const Eigen::Vector4d q{1.0, X.x, X.y, 0.5 * r2};
            normal += q * q.transpose();
            right += u(2, i) * q;
        }
    }
    return normal.ldlt().solve(right)[3];
}

/// Of the plate in equilibrium at t = 1, by conjugate gradients. Rigid motions are left out by themselves: forces are
/// orthogonal to them.
inline double curvature_of(const Plate& plate)
{
    tlsph::TlsphSolver solver(plate.particles, plate.tissue);
    const std::size_t count = plate.cloud.positions.size();
    std::vector<Vec3> growth_forces(count);
    solver.evaluate(plate.cloud.positions, 1.0, growth_forces);
    Displacement residual(3, count);
    for (std::size_t i = 0; i < count; ++i)
    {
        residual.col(i) << growth_forces[i].x, growth_forces[i].y, growth_forces[i].z;
    }
    const auto preconditioned = [&](const Displacement& r)
    {
        Displacement z = r;
        for (std::size_t i = 0; i < count; ++i)
        {
            z.col(i) /= plate.cloud.volumes[i];
        }
        return z;
    };
    Displacement u = Displacement::Zero(3, count);
    Displacement direction = preconditioned(residual);
    double product = residual.cwiseProduct(direction).sum();
    const double first = product;
    double last = 0.0;
    for (int iteration = 1; iteration < 4000 && product > 1e-14 * first; ++iteration)
    {
        const Displacement forces = linear_forces(solver, plate, direction);
        const double length = -product / direction.cwiseProduct(forces).sum();
        u += length * direction;
        residual += length * forces;
        const Displacement z = preconditioned(residual);
        const double next = residual.cwiseProduct(z).sum();
        direction = z + next / product * direction;
        product = next;
        if (iteration % 100 == 0)
        {
            const double curvature = fitted_curvature(plate, u);
            if (std::abs(curvature - last) < 2e-6 * std::abs(curvature))
            {
                break;
            }
            last = curvature;
        }
    }
    return fitted_curvature(plate, u);
}

} // namespace corticle::test

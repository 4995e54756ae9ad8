// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/extrapolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace corticle::fem
{

namespace
{

/// Eigenvectors of a symmetric matrix as the columns of a rotation, by Jacobi's rotations; eigenvalues fall.
Mat3 principal_axes(Mat3 a)
{
    constexpr int most_sweeps = 12;
    constexpr double round_off = 1e-30;
    constexpr std::array<std::array<int, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
    Mat3 axes = Mat3::identity();
    const double size = contract(a, a);
    for (int sweep = 0; sweep < most_sweeps; ++sweep)
    {
        if (a(0, 1) * a(0, 1) + a(0, 2) * a(0, 2) + a(1, 2) * a(1, 2) <= round_off * size)
        {
            break;
        }
        for (const auto& [p, q] : pairs)
        {
            if (a(p, q) != 0.0)
            {
                const double ratio = (a(q, q) - a(p, p)) / (2.0 * a(p, q));
                const double tangent = std::copysign(1.0, ratio) / (std::abs(ratio) + std::hypot(1.0, ratio));
                const double cosine = 1.0 / std::hypot(1.0, tangent);
                Mat3 turn = Mat3::identity();
                turn(p, p) = turn(q, q) = cosine;
                turn(p, q) = tangent * cosine;
                turn(q, p) = -tangent * cosine;
                a = transpose(turn) * (a * turn);
                axes = axes * turn;
            }
        }
    }
    std::array<int, 3> order{0, 1, 2};
    std::ranges::sort(order, [&](int i, int j) { return a(i, i) > a(j, j); });
    const Vec3 first = axes.column[order[0]];
    const Vec3 second = axes.column[order[1]];
    return {{first, second, cross(first, second)}};
}

/// A unit vector along `along`, less its part along `other`; any perpendicular to `other` where nothing is left.
Vec3 unit_across(const Vec3& along, const Vec3& other)
{
    const Vec3 across = along - dot(along, other) * other;
    if (squared_norm(across) > 1e-24 * squared_norm(along))
    {
        return normalized(across);
    }
    const Vec3 axis = std::abs(other.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0};
    return normalized(cross(other, axis));
}

} // namespace

SingularValues singular_values(const Mat3& F)
{
    SingularValues result;
    result.V = principal_axes(transpose(F) * F);
    const Mat3 images = F * result.V;
    const Vec3 first = squared_norm(images.column[0]) > 0.0 ? normalized(images.column[0]) : Vec3{1, 0, 0};
    const Vec3 second = unit_across(images.column[1], first);
    const Vec3 third = cross(first, second);
    result.U = {{first, second, third}};
    result.stretch = {dot(first, images.column[0]), dot(second, images.column[1]), dot(third, images.column[2])};
    return result;
}

} // namespace corticle::fem

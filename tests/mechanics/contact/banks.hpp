// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "geometry/simple_surfaces.hpp"

#include <cmath>

namespace corticle::test
{

/// A square grid of triangles with unit edges, `cells` by `cells`, in the plane z = height, shifted in that plane.
inline TriangleMesh sheet(int cells, double height, double shift_x, double shift_y)
{
    TriangleMesh mesh;
    for (int row = 0; row <= cells; ++row)
    {
        for (int col = 0; col <= cells; ++col)
        {
            mesh.vertices.push_back({col + shift_x, row + shift_y, height});
        }
    }
    const auto vertex = [&](int col, int row) { return static_cast<std::int32_t>(row * (cells + 1) + col); };
    for (int row = 0; row < cells; ++row)
    {
        for (int col = 0; col < cells; ++col)
        {
            mesh.triangles.push_back({vertex(col, row), vertex(col + 1, row), vertex(col + 1, row + 1)});
            mesh.triangles.push_back({vertex(col, row), vertex(col + 1, row + 1), vertex(col, row + 1)});
        }
    }
    return mesh;
}

/// Two sheets that face each other; the second one is smaller, so that its vertices lie over inner points of triangles
/// of the first, and its rim is farther than 0.3 from the nearest vertex beside it.
struct Banks
{
    TriangleMesh mesh;
    std::size_t lower_count = 0; ///< vertices of the lower bank come first

    explicit Banks(double gap)
    {
        const TriangleMesh lower = sheet(5, 0.0, 0.0, 0.0);
        lower_count = lower.vertices.size();
        mesh = together(lower, sheet(3, gap, 0.61, 0.43));
    }
    std::vector<double> masses() const
    {
        std::vector<double> result;
        for (std::size_t k = 0; k < mesh.vertices.size(); ++k)
        {
            result.push_back(0.5 + 0.01 * static_cast<double>(k));
        }
        return result;
    }
};

} // namespace corticle::test

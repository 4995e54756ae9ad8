// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/shapes.hpp"
#include "corticle/mesh/sizes.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace corticle::geometry
{

namespace
{

using Place = std::array<int, 3>; ///< of a vertex in the grid of a box

/// Numbers the places of a grid on the surface of a box as they are met.
class BoxGrid
{
  public:
    BoxGrid(const Vec3& size, const Place& cells) : size_(size), cells_(cells) {}

    std::int32_t vertex(const Place& place)
    {
        const auto [found, is_new] = numbers_.try_emplace(place, static_cast<std::int32_t>(mesh_.vertices.size()));
        if (is_new)
        {
            Vec3 at;
            for (int axis = 0; axis < 3; ++axis)
            {
                at[axis] = size_[axis] * (static_cast<double>(place[axis]) / cells_[axis] - 0.5);
            }
            mesh_.vertices.push_back(at);
        }
        return found->second;
    }

    /// Both faces across an axis.
    void add_faces(int axis)
    {
        const int u = (axis + 1) % 3;
        const int v = (axis + 2) % 3;
        for (const bool high : {false, true})
        {
            for (int i = 0; i < cells_[u]; ++i)
            {
                for (int j = 0; j < cells_[v]; ++j)
                {
                    add_square(axis, high, {i, j});
                }
            }
        }
    }

    TriangleMesh take() { return std::move(mesh_); }

  private:
    /// Two triangles, counter-clockwise seen from outside.
    void add_square(int axis, bool high, const std::array<int, 2>& cell)
    {
        const auto corner = [&](int du, int dv)
        {
            Place place{};
            place[axis] = high ? cells_[axis] : 0;
            place[(axis + 1) % 3] = cell[0] + du;
            place[(axis + 2) % 3] = cell[1] + dv;
            return vertex(place);
        };
        std::array<std::int32_t, 4> round{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        if (!high)
        {
            std::swap(round[1], round[3]);
        }
        const int first = (cell[0] + cell[1]) % 2; // diagonals of neighbours cross
        for (const int k : {first, first + 2})
        {
            mesh_.triangles.push_back({round[k], round[(k + 1) % 4], round[(k + 2) % 4]});
        }
    }

    Vec3 size_;
    Place cells_;
    std::map<Place, std::int32_t> numbers_;
    TriangleMesh mesh_;
};

} // namespace

TriangleMesh make_box(const Vec3& size, double edge_length)
{
    require_positive("box: edge length [mm]", edge_length);
    const double side = std::sqrt(0.5 * std::sqrt(3.0)) * edge_length; // as many vertices as regular triangles have
    Place cells{};
    for (int axis = 0; axis < 3; ++axis)
    {
        require_positive("box: length [mm]", size[axis]);
        cells[axis] = std::max(1, static_cast<int>(std::lround(size[axis] / side)));
    }
    BoxGrid grid(size, cells);
    for (int axis = 0; axis < 3; ++axis)
    {
        grid.add_faces(axis);
    }
    return grid.take();
}

} // namespace corticle::geometry

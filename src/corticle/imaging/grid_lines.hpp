// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/parallel.hpp"
#include "corticle/imaging/voxel_grid.hpp"

namespace corticle::imaging
{

/// Calls line(first) for the first voxel of every line of the grid along an axis, concurrently.
template <class Line>
void for_lines(const VoxelGrid& grid, int axis, Line&& line)
{
    const int u = axis == 0 ? 1 : 0;
    const int v = axis == 2 ? 1 : 2;
    parallel_for(grid.size[u] * grid.size[v],
                 [&](std::int64_t k) { line(k % grid.size[u] * grid.stride(u) + k / grid.size[u] * grid.stride(v)); });
}

} // namespace corticle::imaging

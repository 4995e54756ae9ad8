// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/voxel_grid.hpp"

#include "corticle/mesh/sizes.hpp"

#include <algorithm>

namespace corticle::imaging
{

void require_voxels(const VoxelGrid& grid, std::string_view what, std::size_t count)
{
    for (const std::int64_t size : grid.size)
    {
        require_positive("voxels along an axis", static_cast<double>(size));
    }
    require_size(what, count, static_cast<std::size_t>(grid.count()));
}

std::int64_t voxel_count(const Mask& mask)
{
    return std::count(mask.begin(), mask.end(), std::uint8_t{1});
}

} // namespace corticle::imaging

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/regions/nearest_labels.hpp"

#include "corticle/base/parallel.hpp"

#include <cmath>
#include <limits>

namespace corticle::regions
{

std::vector<double> nearest_labels(const imaging::LabelVolume& volume, std::span<const Vec3> places, int reach)
{
    const Mat3 to_index = inverse(volume.frame.linear);
    const auto label_at = [&](const std::array<std::int64_t, 3>& at)
    {
        const bool is_inside = at[0] >= 0 && at[1] >= 0 && at[2] >= 0 && at[0] < volume.size[0] &&
                               at[1] < volume.size[1] && at[2] < volume.size[2];
        return is_inside ? volume.labels[at[0] + volume.size[0] * (at[1] + volume.size[1] * at[2])] : 0;
    };
    std::vector<double> labels(places.size());
    parallel_for(std::ssize(places),
                 [&](std::int64_t k)
                 {
                     const Vec3 index = to_index * (places[k] - volume.frame.origin);
                     double nearest = std::numeric_limits<double>::infinity();
                     for (int z = -reach; z <= reach; ++z)
                     {
                         for (int y = -reach; y <= reach; ++y)
                         {
                             for (int x = -reach; x <= reach; ++x)
                             {
                                 const std::array<std::int64_t, 3> at{
                                     std::llround(index.x) + x, std::llround(index.y) + y, std::llround(index.z) + z};
                                 const std::int32_t label = label_at(at);
                                 const Vec3 centre{static_cast<double>(at[0]), static_cast<double>(at[1]),
                                                   static_cast<double>(at[2])};
                                 const double distance = squared_norm(volume.frame.linear * (centre - index));
                                 if (label != 0 && distance < nearest)
                                 {
                                     nearest = distance;
                                     labels[k] = label;
                                 }
                             }
                         }
                     }
                 });
    return labels;
}

} // namespace corticle::regions

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/owner_blocks.hpp"
#include "corticle/mechanics/contact/surface_contact.hpp"

#include <algorithm>

namespace corticle::contact
{

template <class Pair>
void SurfaceContact::add_wall_contact(const Owners<Pair>& owners, WallContact& sum) const
{
    for (std::size_t block = 0; block < owners.count.size(); ++block)
    {
        const auto first = static_cast<std::int64_t>(block) * owners_at_a_time;
        for (std::int64_t m = first; m < first + owners.count[block]; ++m)
        {
            const Push& push = owners.pushes[m];
            if (std::ranges::none_of(push.vertex, [&](std::int32_t vertex) { return vertex >= wall_; }))
            {
                continue;
            }
            const std::int32_t owner = owners.repelling[m];
            sum.force += norm(push.force);
            sum.energy += owners.barrier[owner].energy(owners.closest[0][owner].distance);
            for (const std::int32_t vertex : push.vertex)
            {
                if (vertex < wall_)
                {
                    sum.is_pushed[static_cast<std::size_t>(vertex)] = 1;
                }
            }
        }
    }
}

WallContact SurfaceContact::wall_contact() const
{
    WallContact sum;
    if (wall_ != no_wall)
    {
        sum.is_pushed.resize(static_cast<std::size_t>(wall_));
        add_wall_contact(vertices_, sum);
        add_wall_contact(edges_, sum);
    }
    return sum;
}

} // namespace corticle::contact

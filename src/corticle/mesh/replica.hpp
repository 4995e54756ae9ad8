// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"
#include "corticle/mesh/share.hpp"

#include <algorithm>
#include <array>
#include <span>
#include <vector>

namespace corticle
{

/// Of ascending particles, the place of the first that each rank owns, and their number as one entry more.
inline std::vector<std::int64_t> first_of_ranks(const Share& share, std::span<const std::int32_t> particles)
{
    std::vector<std::int64_t> first;
    for (const std::int64_t particle : share.partition().first)
    {
        first.push_back(std::ranges::lower_bound(particles, particle) - particles.begin());
    }
    return first;
}

/// Particles whose vectors every rank knows, such as those of the surface: what is worked out from them alone, all
/// ranks work out alike.
class Replica
{
  public:
    /// @param particles  in any order; those named twice count once
    Replica(const Share& share, std::vector<std::int32_t> particles) : share_(&share), particles_(std::move(particles))
    {
        std::ranges::sort(particles_);
        particles_.erase(std::unique(particles_.begin(), particles_.end()), particles_.end());
        first_ = first_of_ranks(share, particles_);
    }

    std::span<const std::int32_t> particles() const { return particles_; }

    /// Of vectors of all particles, sets those of the replica to what their owners have. Collective.
    template <class... Vectors>
    void gather(Vectors&... vectors) const
    {
        if (!share_->is_part() || particles_.empty())
        {
            return;
        }
        constexpr std::size_t width = 3 * sizeof...(Vectors);
        std::vector<std::array<double, width>> rows(particles_.size());
        const auto rank = static_cast<std::size_t>(share_->ranks().rank());
        for (auto k = static_cast<std::size_t>(first_[rank]); k < static_cast<std::size_t>(first_[rank + 1]); ++k)
        {
            std::size_t at = 0;
            ((rows[k][at] = vectors[particles_[k]].x, rows[k][at + 1] = vectors[particles_[k]].y,
              rows[k][at + 2] = vectors[particles_[k]].z, at += 3),
             ...);
        }
        share_->ranks().gather(std::span(rows), std::span<const std::int64_t>(first_));
        parallel_for(std::ssize(particles_),
                     [&](std::int64_t k)
                     {
                         const std::int32_t i = particles_[static_cast<std::size_t>(k)];
                         if (!share_->has(i))
                         {
                             const auto& row = rows[static_cast<std::size_t>(k)];
                             std::size_t at = 0;
                             ((vectors[i] = Vec3{row[at], row[at + 1], row[at + 2]}, at += 3), ...);
                         }
                     });
    }

  private:
    const Share* share_;
    std::vector<std::int32_t> particles_; ///< ascending
    std::vector<std::int64_t> first_;     ///< of them that each rank owns, one entry more than there are ranks
};

} // namespace corticle

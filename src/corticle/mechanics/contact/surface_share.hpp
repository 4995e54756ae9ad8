// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/replica.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

namespace corticle::contact
{

/// The vertices of a surface for which a rank works out contact: those of its own particles, or all of them. Every rank
/// knows where all vertices are.
class SurfaceShare
{
  public:
    /// All vertices.
    SurfaceShare() = default;
    /// @param particles  of the vertices, ascending
    SurfaceShare(const Share& share, std::span<const std::int32_t> particles)
    {
        if (!share.is_part())
        {
            return;
        }
        ranks_ = &share.ranks();
        first_ = first_of_ranks(share, particles);
        const auto rank = static_cast<std::size_t>(ranks_->rank());
        begin_ = first_[rank];
        end_ = first_[rank + 1];
    }

    /// Whether other ranks have vertices.
    bool is_part() const { return ranks_ != nullptr; }
    bool has(std::int32_t vertex) const { return !is_part() || (vertex >= begin_ && vertex < end_); }

    /// Every rank has set the values of its vertices; all get the others'. Collective.
    template <class Item>
    void gather(std::span<Item> of_vertices) const
    {
        if (is_part())
        {
            ranks_->gather(of_vertices, std::span<const std::int64_t>(first_));
        }
    }
    /// The items of all ranks, in the order of the ranks. Collective.
    template <class Item>
    std::vector<Item> of_all(std::vector<Item> own) const
    {
        if (!is_part())
        {
            return own;
        }
        const auto rank = static_cast<std::size_t>(ranks_->rank());
        const auto size = static_cast<std::size_t>(ranks_->size());
        std::vector<std::int64_t> one_each(size + 1);
        std::iota(one_each.begin(), one_each.end(), 0);
        std::vector<std::int64_t> first(size + 1);
        first[rank + 1] = std::ssize(own);
        ranks_->gather(std::span(first).subspan(1), std::span<const std::int64_t>(one_each));
        std::partial_sum(first.begin(), first.end(), first.begin());
        std::vector<Item> all(static_cast<std::size_t>(first.back()));
        std::ranges::copy(own, all.begin() + first[rank]);
        ranks_->gather(std::span(all), std::span<const std::int64_t>(first));
        return all;
    }
    /// Whether any rank says so. Collective.
    bool any(bool flag) const { return is_part() ? ranks_->any(flag ? 1U : 0U) != 0 : flag; }
    /// The largest of what the ranks have. Collective.
    double largest(double own) const { return std::ranges::max(of_all(std::vector<double>{own})); }

  private:
    const Communicator* ranks_ = nullptr; ///< null: not shared
    std::vector<std::int64_t> first_;     ///< vertex of each rank, one entry more than there are ranks
    std::int64_t begin_ = 0;
    std::int64_t end_ = 0;
};

} // namespace corticle::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/communicator.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/mesh/partition.hpp"

#include <numeric>

namespace corticle
{

/// The particles of a body that a rank works on: those it owns, or all of them where the work is not shared. Particles
/// keep their numbers: arrays have entries for all, of which a rank sets its own.
class Share
{
  public:
    /// All particles. @param ranks  where others do the same work too
    explicit Share(std::int64_t particles, const Communicator& ranks = alone())
        : ranks_(&ranks), partition_{{0, particles}}, begin_(0), end_(particles)
    {
    }
    Share(Partition partition, const Communicator& ranks)
        : ranks_(&ranks), partition_(std::move(partition)), begin_(partition_.begin(ranks.rank())),
          end_(partition_.end(ranks.rank()))
    {
    }

    const Communicator& ranks() const { return *ranks_; }
    const Partition& partition() const { return partition_; }
    /// Whether other ranks own particles.
    bool is_part() const { return partition_.ranks() > 1; }
    std::int64_t begin() const { return begin_; } ///< first particle
    std::int64_t end() const { return end_; }
    std::int64_t size() const { return end_ - begin_; }
    std::int64_t particles() const { return partition_.first.back(); } ///< of all ranks
    bool has(std::int64_t particle) const { return particle >= begin_ && particle < end_; }

    /// Calls body(i) for the own particles, concurrently.
    template <class Body>
    void each(Body&& body) const
    {
        parallel_for(size(), [&](std::int64_t i) { body(begin_ + i); });
    }

    /// parallel_reduce over the particles of all ranks, to the bits that one rank gets. Collective.
    template <class T, class BlockValue, class Join>
    T reduce(T initial, BlockValue&& block_value, Join&& join, std::int64_t block_size = parallel_block) const;
    /// parallel_sum over the particles of all ranks. Collective.
    template <class Value>
    double sum(Value&& value) const;

    /// Every rank has set the values of its particles; all get the others'. Collective.
    template <class Item>
    void gather(std::span<Item> values) const
    {
        if (is_part())
        {
            ranks_->gather(values, std::span<const std::int64_t>(partition_.first));
        }
    }
    /// The same, where only rank 0 gets them.
    template <class Item>
    void gather_at_root(std::span<Item> values) const
    {
        if (is_part())
        {
            ranks_->gather_at_root(values, std::span<const std::int64_t>(partition_.first));
        }
    }

  private:
    const Communicator* ranks_;
    Partition partition_;
    std::int64_t begin_;
    std::int64_t end_;
};

/// Values of all blocks of particles, to be joined in the order of the blocks whoever found them. Every rank puts in
/// those of its own blocks.
template <class T>
class BlockValues
{
  public:
    /// @param block_size  divides partition_block
    BlockValues(const Share& share, const T& initial, std::int64_t block_size)
        : share_(share), initial_(initial), block_size_(block_size),
          values_(static_cast<std::size_t>(block_count(share.particles(), block_size)), initial)
    {
    }

    /// Sets the values of some of the own blocks to block_value(begin, end) of their particles, concurrently.
    template <class BlockValue>
    void find(std::span<const std::int64_t> blocks, BlockValue&& block_value)
    {
        parallel_blocks(
            std::ssize(blocks),
            [&](std::int64_t k, std::int64_t) { find(blocks[static_cast<std::size_t>(k)], block_value); }, 1);
    }
    /// Those of all own blocks.
    template <class BlockValue>
    void find(BlockValue&& block_value)
    {
        const std::int64_t first = share_.begin() / block_size_;
        parallel_blocks(
            share_.size(), [&](std::int64_t begin, std::int64_t) { find(first + begin / block_size_, block_value); },
            block_size_);
    }

    /// Joins the values of the blocks of all ranks. Collective.
    template <class Join>
    T joined(Join&& join)
    {
        if (share_.is_part())
        {
            std::vector<std::int64_t> first;
            for (const std::int64_t particle : share_.partition().first)
            {
                first.push_back(block_count(particle, block_size_));
            }
            share_.ranks().gather(std::span(values_), std::span<const std::int64_t>(first));
        }
        T result = initial_;
        for (const T& value : values_)
        {
            join(result, value);
        }
        return result;
    }

  private:
    template <class BlockValue>
    void find(std::int64_t block, const BlockValue& block_value)
    {
        const std::int64_t begin = block * block_size_;
        values_[static_cast<std::size_t>(block)] = block_value(begin, std::min(begin + block_size_, share_.end()));
    }

    const Share& share_;
    T initial_;
    std::int64_t block_size_;
    std::vector<T> values_;
};

template <class T, class BlockValue, class Join>
T Share::reduce(T initial, BlockValue&& block_value, Join&& join, std::int64_t block_size) const
{
    BlockValues<T> values(*this, initial, block_size);
    values.find(block_value);
    return values.joined(join);
}

template <class Value>
double Share::sum(Value&& value) const
{
    return reduce(
        0.0,
        [&](std::int64_t begin, std::int64_t end)
        {
            double part = 0.0;
            for (std::int64_t i = begin; i < end; ++i)
            {
                part += value(i);
            }
            return part;
        },
        [](double& total, double part) { total += part; });
}

} // namespace corticle

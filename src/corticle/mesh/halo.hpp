// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/share.hpp"

#include <algorithm>

namespace corticle
{

/// What a rank and one of its neighbours read of each other.
struct HaloPart
{
    int rank;                         ///< the neighbour
    std::vector<std::int32_t> ours;   ///< own particles that it reads, ascending
    std::vector<std::int32_t> ghosts; ///< particles of its that are read here, ascending
};

/// The halo of a rank's particles where particles read their neighbours, and are read by the same.
/// @param each_neighbor  each_neighbor(i, act) calls act(j) for every neighbour j of particle i
template <class EachNeighbor>
std::vector<HaloPart> find_halo(const Partition& partition, int rank, EachNeighbor&& each_neighbor)
{
    std::vector<HaloPart> of_rank(static_cast<std::size_t>(partition.ranks()));
    const std::int64_t begin = partition.begin(rank);
    const std::int64_t end = partition.end(rank);
    std::vector<std::uint8_t> is_ghost(static_cast<std::size_t>(partition.first.back()));
    for (std::int64_t i = begin; i < end; ++i)
    {
        each_neighbor(i,
                      [&](std::int32_t j)
                      {
                          if (j < begin || j >= end)
                          {
                              auto& ours = of_rank[static_cast<std::size_t>(partition.owner_of(j))].ours;
                              if (ours.empty() || ours.back() != i)
                              {
                                  ours.push_back(static_cast<std::int32_t>(i));
                              }
                              is_ghost[static_cast<std::size_t>(j)] = 1;
                          }
                      });
    }
    std::vector<HaloPart> parts;
    for (int other = 0; other < partition.ranks(); ++other)
    {
        HaloPart& part = of_rank[static_cast<std::size_t>(other)];
        part.rank = other;
        for (std::int64_t j = partition.begin(other); j < partition.end(other) && !part.ours.empty(); ++j)
        {
            if (is_ghost[static_cast<std::size_t>(j)] != 0)
            {
                part.ghosts.push_back(static_cast<std::int32_t>(j));
            }
        }
        if (!part.ours.empty())
        {
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

/// Sends numbers of own particles to those who read them, and gets those of ghosts.
class Halo
{
  public:
    /// @param size_of  how many numbers go for particle i, a function of i
    template <class SizeOf>
    Halo(const std::vector<HaloPart>& parts, const Communicator& ranks, SizeOf&& size_of) : parts_(parts)
    {
        const auto parcel = [&](int rank, const std::vector<std::int32_t>& particles)
        {
            std::size_t size = 0;
            for (const std::int32_t i : particles)
            {
                size += size_of(i);
            }
            return Parcel{rank, std::vector<double>(size)};
        };
        for (const HaloPart& part : parts_)
        {
            outgoing_.push_back(parcel(part.rank, part.ours));
            incoming_.push_back(parcel(part.rank, part.ghosts));
        }
        exchange_ = ranks.exchange(outgoing_, incoming_);
    }

    /// @param pack  pack(i, at) writes the numbers of particle i and returns where the next ones go
    template <class Pack>
    void start(Pack&& pack)
    {
        parallel_blocks(
            std::ssize(parts_),
            [&](std::int64_t k, std::int64_t)
            {
                double* at = outgoing_[static_cast<std::size_t>(k)].numbers.data();
                for (const std::int32_t i : parts_[static_cast<std::size_t>(k)].ours)
                {
                    at = pack(i, at);
                }
            },
            1);
        exchange_->start();
    }

    /// @param unpack  unpack(i, at) reads the numbers of ghost i and returns where the next ones are
    template <class Unpack>
    void finish(Unpack&& unpack)
    {
        exchange_->finish();
        parallel_blocks(
            std::ssize(parts_),
            [&](std::int64_t k, std::int64_t)
            {
                const double* at = incoming_[static_cast<std::size_t>(k)].numbers.data();
                for (const std::int32_t i : parts_[static_cast<std::size_t>(k)].ghosts)
                {
                    at = unpack(i, at);
                }
            },
            1);
    }

    std::span<const HaloPart> parts() const { return parts_; }

  private:
    std::vector<HaloPart> parts_;
    std::vector<Parcel> outgoing_; ///< one for each part
    std::vector<Parcel> incoming_;
    std::unique_ptr<Exchange> exchange_;
};

} // namespace corticle

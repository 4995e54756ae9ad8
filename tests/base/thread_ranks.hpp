// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/communicator.hpp"
#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <barrier>
#include <condition_variable>
#include <cstring>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace corticle::test
{

/// What ranks that are threads of one process share.
struct ThreadTeam
{
    explicit ThreadTeam(int size)
        : here(size), shown(static_cast<std::size_t>(size)), flags(static_cast<std::size_t>(size)),
          sent(static_cast<std::size_t>(size)), outgoing(static_cast<std::size_t>(size))
    {
    }

    std::barrier<> here;
    std::vector<const void*> shown; ///< of each rank, in the collective call at hand
    std::vector<unsigned> flags;
    std::mutex mutex;
    std::condition_variable arrived;
    std::vector<std::deque<std::vector<std::byte>>> sent; ///< to each rank
    std::vector<std::vector<std::span<Parcel>>> outgoing; ///< of each rank, of each exchange
};

class ThreadExchange final : public Exchange
{
  public:
    ThreadExchange(ThreadTeam& team, int rank, std::span<Parcel> outgoing, std::span<Parcel> incoming)
        : team_(team), rank_(rank), incoming_(incoming), number_(team.outgoing[static_cast<std::size_t>(rank)].size())
    {
        team.outgoing[static_cast<std::size_t>(rank)].push_back(outgoing);
        team.here.arrive_and_wait();
    }
    void finish() override
    {
        team_.here.arrive_and_wait();
        for (Parcel& parcel : incoming_)
        {
            const auto from = team_.outgoing[static_cast<std::size_t>(parcel.rank)][number_];
            const auto found = std::ranges::find(from, rank_, &Parcel::rank);
            parcel.numbers.assign(found->numbers.begin(), found->numbers.end());
        }
        team_.here.arrive_and_wait();
    }

  private:
    ThreadTeam& team_;
    int rank_;
    std::span<Parcel> incoming_;
    std::size_t number_;
};

/// One of the ranks.
class ThreadRank final : public Communicator
{
  public:
    ThreadRank(ThreadTeam& team, int rank) : team_(team), rank_(rank) {}

    int rank() const override { return rank_; }
    int size() const override { return static_cast<int>(team_.shown.size()); }

    void send(std::span<const std::byte> bytes, int to) const override
    {
        const std::lock_guard lock(team_.mutex);
        team_.sent[static_cast<std::size_t>(to)].emplace_back(bytes.begin(), bytes.end());
        team_.arrived.notify_all();
    }
    void receive(std::span<std::byte> bytes) const override
    {
        auto& mine = team_.sent[static_cast<std::size_t>(rank_)];
        std::unique_lock lock(team_.mutex);
        team_.arrived.wait(lock, [&] { return !mine.empty(); });
        std::ranges::copy(mine.front(), bytes.begin());
        mine.pop_front();
    }
    unsigned any(unsigned flags) const override
    {
        team_.flags[static_cast<std::size_t>(rank_)] = flags;
        team_.here.arrive_and_wait();
        unsigned all = 0;
        for (const unsigned of_rank : team_.flags)
        {
            all |= of_rank;
        }
        team_.here.arrive_and_wait();
        return all;
    }
    std::unique_ptr<Exchange> exchange(std::span<Parcel> outgoing, std::span<Parcel> incoming) const override
    {
        return std::make_unique<ThreadExchange>(team_, rank_, outgoing, incoming);
    }

  protected:
    void gather_words(std::span<Word> all, const std::vector<std::int64_t>& first, bool at_root_alone) const override
    {
        show(all.data());
        for (std::size_t k = 0; k < team_.shown.size(); ++k)
        {
            if (static_cast<int>(k) != rank_ && (is_root() || !at_root_alone))
            {
                const auto* const from = static_cast<const Word*>(team_.shown[k]);
                std::copy(from + first[k], from + first[k + 1], all.begin() + first[k]);
            }
        }
        team_.here.arrive_and_wait();
    }
    void broadcast_bytes(std::span<std::byte> bytes) const override
    {
        show(bytes.data());
        if (!is_root() && !bytes.empty())
        {
            std::memcpy(bytes.data(), team_.shown[0], bytes.size());
        }
        team_.here.arrive_and_wait();
    }

  private:
    void show(const void* data) const
    {
        team_.shown[static_cast<std::size_t>(rank_)] = data;
        team_.here.arrive_and_wait();
    }

    ThreadTeam& team_;
    int rank_;
};

/// Calls work(rank) for every rank of a team, each in a thread of its own that has `threads` threads for its loops.
/// What work throws must be thrown by all ranks.
inline void with_ranks(int size, int threads, const std::function<void(const Communicator&)>& work)
{
    ThreadTeam team(size);
    std::vector<std::exception_ptr> thrown(static_cast<std::size_t>(size));
    std::vector<std::thread> running;
    for (int rank = 0; rank < size; ++rank)
    {
        running.emplace_back(
            [&, rank]
            {
                set_thread_count(threads);
                try
                {
                    work(ThreadRank(team, rank));
                }
                catch (...)
                {
                    thrown[static_cast<std::size_t>(rank)] = std::current_exception();
                }
            });
    }
    for (std::thread& thread : running)
    {
        thread.join();
    }
    for (const std::exception_ptr& exception : thrown)
    {
        if (exception)
        {
            std::rethrow_exception(exception);
        }
    }
}

} // namespace corticle::test

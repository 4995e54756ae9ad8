// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/communicator.hpp"
#include "corticle/base/error.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <limits>

// Of a build with MPI: the only file that knows it.

namespace corticle
{

namespace
{

/// As MPI counts, in int.
int as_count(std::int64_t value)
{
    if (value > std::numeric_limits<int>::max())
    {
        throw RunError(fmt::format("a message of {} items is more than MPI can count", value));
    }
    return static_cast<int>(value);
}

/// Messages that are set up once.
class PersistentExchange final : public Exchange
{
  public:
    PersistentExchange(MPI_Comm world, std::span<Parcel> outgoing, std::span<Parcel> incoming)
    {
        constexpr int tag = 1;
        for (Parcel& parcel : incoming)
        {
            MPI_Recv_init(parcel.numbers.data(), as_count(std::ssize(parcel.numbers)), MPI_DOUBLE, parcel.rank, tag,
                          world, &requests_.emplace_back());
        }
        for (const Parcel& parcel : outgoing)
        {
            MPI_Send_init(parcel.numbers.data(), as_count(std::ssize(parcel.numbers)), MPI_DOUBLE, parcel.rank, tag,
                          world, &requests_.emplace_back());
        }
    }
    ~PersistentExchange() override
    {
        for (MPI_Request& request : requests_)
        {
            MPI_Request_free(&request);
        }
    }

    void start() override
    {
        if (!requests_.empty()) // else MPI_Startall would abort
        {
            MPI_Startall(static_cast<int>(requests_.size()), requests_.data());
        }
    }
    void finish() override { MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE); }

  private:
    std::vector<MPI_Request> requests_;
};

class MpiCommunicator final : public Communicator
{
  public:
    MpiCommunicator()
    {
        int provided = 0;
        MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided);
        MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
        MPI_Comm_size(MPI_COMM_WORLD, &size_);
        MPI_Comm_dup(MPI_COMM_WORLD, &exchanges_);
        MPI_Comm_dup(MPI_COMM_WORLD, &meetings_);
    }
    /// Waits for the others.
    ~MpiCommunicator() override { MPI_Finalize(); }

    int rank() const override { return rank_; }
    int size() const override { return size_; }

    void send(std::span<const std::byte> bytes, int to) const override
    {
        in_pieces(bytes,
                  [&](const std::byte* data, int count) { MPI_Send(data, count, MPI_BYTE, to, 0, MPI_COMM_WORLD); });
    }
    void receive(std::span<std::byte> bytes) const override
    {
        in_pieces(bytes, [&](std::byte* data, int count)
                  { MPI_Recv(data, count, MPI_BYTE, 0, 0, MPI_COMM_WORLD, MPI_STATUS_IGNORE); });
    }

    unsigned any(unsigned flags) const override
    {
        unsigned all = 0;
        MPI_Allreduce(&flags, &all, 1, MPI_UNSIGNED, MPI_BOR, MPI_COMM_WORLD);
        return all;
    }

    std::unique_ptr<Exchange> exchange(std::span<Parcel> outgoing, std::span<Parcel> incoming) const override
    {
        return std::make_unique<PersistentExchange>(exchanges_, outgoing, incoming);
    }

    bool meet(double seconds) const override
    {
        constexpr unsigned poll_us = 1000;
        MPI_Request request{};
        MPI_Ibarrier(meetings_, &request);
        const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
        int is_done = 0;
        while (is_done == 0 && std::chrono::steady_clock::now() < end)
        {
            MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
            usleep(poll_us);
        }
        return is_done != 0;
    }
    [[noreturn]] void abort(int status) const override
    {
        MPI_Abort(MPI_COMM_WORLD, status);
        Communicator::abort(status);
    }

  protected:
    void gather_words(std::span<Word> all, const std::vector<std::int64_t>& first, bool at_root_alone) const override
    {
        std::vector<int> counts;
        std::vector<int> begins;
        for (std::size_t k = 0; k + 1 < first.size(); ++k)
        {
            begins.push_back(as_count(first[k]));
            counts.push_back(as_count(first[k + 1] - first[k]));
        }
        if (!at_root_alone)
        {
            MPI_Allgatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all.data(), counts.data(), begins.data(), MPI_UINT64_T,
                           MPI_COMM_WORLD);
        }
        else if (is_root())
        {
            MPI_Gatherv(MPI_IN_PLACE, 0, MPI_DATATYPE_NULL, all.data(), counts.data(), begins.data(), MPI_UINT64_T, 0,
                        MPI_COMM_WORLD);
        }
        else
        {
            const auto k = static_cast<std::size_t>(rank_);
            MPI_Gatherv(all.data() + first[k], counts[k], MPI_UINT64_T, nullptr, nullptr, nullptr, MPI_UINT64_T, 0,
                        MPI_COMM_WORLD);
        }
    }
    void broadcast_bytes(std::span<std::byte> bytes) const override
    {
        in_pieces(bytes, [](std::byte* data, int count) { MPI_Bcast(data, count, MPI_BYTE, 0, MPI_COMM_WORLD); });
    }

  private:
    template <class Byte, class Act>
    static void in_pieces(std::span<Byte> bytes, Act&& act)
    {
        constexpr std::size_t piece = std::size_t{1} << 30;
        for (std::size_t at = 0; at < bytes.size(); at += piece)
        {
            act(bytes.data() + at, static_cast<int>(std::min(piece, bytes.size() - at)));
        }
    }

    int rank_ = 0;
    int size_ = 1;
    MPI_Comm exchanges_{};
    MPI_Comm meetings_{};
};

} // namespace

std::unique_ptr<const Communicator> join_ranks()
{
    return std::make_unique<const MpiCommunicator>();
}

} // namespace corticle

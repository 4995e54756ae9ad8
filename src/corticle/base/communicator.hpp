// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

namespace corticle
{

/// Numbers that go to another rank, or come from it.
struct Parcel
{
    int rank;
    std::vector<double> numbers;
};

/// Parcels of constant sizes between ranks, which go out together as often as needed.
class Exchange
{
  public:
    Exchange() = default;
    Exchange(const Exchange&) = delete;
    Exchange& operator=(const Exchange&) = delete;
    virtual ~Exchange() = default;

    /// Lets the parcels go; until finish() nobody touches them.
    virtual void start() {}
    /// Waits until those from others are here, and the own ones have left.
    virtual void finish() {}
};

/// The ranks of a run: processes that share its work. This one is alone; MPI makes more of them
/// (ranks/mpi.cpp). All ranks call what is collective, in the same order.
///
/// There is no sum over ranks: numbers of blocks are gathered, and added up in the same order everywhere (see Share).
class Communicator
{
  public:
    Communicator() = default;
    Communicator(const Communicator&) = delete;
    Communicator& operator=(const Communicator&) = delete;
    virtual ~Communicator() = default;

    virtual int rank() const { return 0; }
    virtual int size() const { return 1; }
    bool is_root() const { return rank() == 0; }

    /// Every rank has set items first[rank] to first[rank + 1] of `all`; gets the others'. Collective.
    template <class Item>
    void gather(std::span<Item> all, std::span<const std::int64_t> first) const
    {
        gather_words(words_of(all), in_words<Item>(first), false);
    }
    /// The same, where only rank 0 gets them.
    template <class Item>
    void gather_at_root(std::span<Item> all, std::span<const std::int64_t> first) const
    {
        gather_words(words_of(all), in_words<Item>(first), true);
    }

    /// Everybody gets the items of rank 0, which are as many as his own. Collective.
    template <class Item>
    void broadcast(std::span<Item> items) const
    {
        static_assert(std::is_trivially_copyable_v<Item>);
        broadcast_bytes(std::as_writable_bytes(items));
    }
    /// The same, however many there are.
    template <class Item>
    void broadcast(std::vector<Item>& items) const
    {
        auto count = static_cast<std::int64_t>(items.size());
        broadcast(std::span(&count, 1));
        items.resize(static_cast<std::size_t>(count));
        broadcast(std::span<Item>(items));
    }

    /// Items from rank 0 to another one. Called by these two.
    virtual void send(std::span<const std::byte> /*bytes*/, int /*to*/) const {}
    virtual void receive(std::span<std::byte> /*bytes*/) const {}

    /// Whether any rank says so, bit by bit. Collective.
    virtual unsigned any(unsigned flags) const { return flags; }

    /// @param outgoing,incoming  one for each neighbour; they must outlive the exchange, and not move
    virtual std::unique_ptr<Exchange> exchange(std::span<Parcel> /*outgoing*/, std::span<Parcel> /*incoming*/) const
    {
        return std::make_unique<Exchange>();
    }

    /// Whether all ranks come to where they call this within some seconds.
    virtual bool meet(double /*seconds*/) const { return true; }
    /// Ends all ranks at once.
    [[noreturn]] virtual void abort(int status) const;

  protected:
    using Word = std::uint64_t;
    /// @param first  in words, one entry more than there are ranks
    virtual void gather_words(std::span<Word> /*all*/, const std::vector<std::int64_t>& /*first*/,
                              bool /*at_root_alone*/) const
    {
    }
    virtual void broadcast_bytes(std::span<std::byte> /*bytes*/) const {}

  private:
    template <class Item>
    static std::span<Word> words_of(std::span<Item> items)
    {
        static_assert(std::is_trivially_copyable_v<Item> && sizeof(Item) % sizeof(Word) == 0);
        return {reinterpret_cast<Word*>(items.data()), items.size() * (sizeof(Item) / sizeof(Word))};
    }
    template <class Item>
    static std::vector<std::int64_t> in_words(std::span<const std::int64_t> first)
    {
        std::vector<std::int64_t> words(first.begin(), first.end());
        for (std::int64_t& word : words)
        {
            word *= static_cast<std::int64_t>(sizeof(Item) / sizeof(Word));
        }
        return words;
    }
};

/// Calls work() on rank 0 while the others wait. What fails there fails on all of them; rank 0 knows why. Collective.
void at_root(const Communicator& ranks, const std::function<void()>& work);

/// The communicator of a process that works by itself.
const Communicator& alone();

/// The ranks that this process was started among, from now until the object goes; called once, before threads are
/// started. @throws InputError where several were started that cannot talk to each other
std::unique_ptr<const Communicator> join_ranks();

} // namespace corticle

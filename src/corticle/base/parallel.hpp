// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <exception>
#include <mutex>
#include <vector>

#ifdef _OPENMP
#include <omp.h>
#endif

// The only file that knows the threads of loops. Work is cut into blocks of a fixed size, whatever the number of
// threads; sums are taken block by block in order, so 1 and N threads give the same bits.

namespace corticle
{

inline constexpr std::int64_t parallel_block = 512;

/// Number of threads the loops below use.
inline int thread_count()
{
#ifdef _OPENMP
    return omp_get_max_threads();
#else
    return 1;
#endif
}

inline void set_thread_count([[maybe_unused]] int count)
{
#ifdef _OPENMP
    if (count > 0)
    {
        omp_set_num_threads(count);
    }
#endif
}

/// Number of the thread that calls, below thread_count().
inline int thread_number()
{
#ifdef _OPENMP
    return omp_get_thread_num();
#else
    return 0;
#endif
}

/// Number of blocks of [0, count).
constexpr std::int64_t block_count(std::int64_t count, std::int64_t block_size = parallel_block)
{
    return (count + block_size - 1) / block_size;
}

/// The first exception of a loop's threads, to be thrown again after the loop: one that leaves a thread ends the
/// process. Loops throw nothing but what nobody can foresee, above all std::bad_alloc.
class LoopFailure
{
  public:
    template <class Work>
    void guard(Work&& work) noexcept
    {
        try
        {
            work();
        }
        catch (...)
        {
            const std::lock_guard lock(mutex_);
            first_ = first_ ? first_ : std::current_exception();
        }
    }
    void rethrow() const
    {
        if (first_)
        {
            std::rethrow_exception(first_);
        }
    }

  private:
    std::mutex mutex_;
    std::exception_ptr first_;
};

/// Calls body(begin, end) for consecutive blocks of [0, count).
template <class Body>
struct BlockLoop
{
    std::int64_t count;
    Body body;
    std::int64_t block_size = parallel_block;

    std::int64_t blocks() const { return block_count(count, block_size); }
    void run_block(std::int64_t block) const
    {
        const std::int64_t begin = block * block_size;
        body(begin, std::min(begin + block_size, count));
    }
    /// The part of the calling thread: a run of blocks, as many as every other thread has.
    void run_part(LoopFailure& failure) const
    {
#pragma omp for schedule(static) nowait
        for (std::int64_t block = 0; block < blocks(); ++block)
        {
            failure.guard([&] { run_block(block); });
        }
    }
};
template <class Body>
BlockLoop(std::int64_t, Body) -> BlockLoop<Body>;
template <class Body>
BlockLoop(std::int64_t, Body, std::int64_t) -> BlockLoop<Body>;

/// Calls body(i) for every i of [0, count).
template <class Body>
auto each(std::int64_t count, Body body)
{
    return BlockLoop{count, [body](std::int64_t begin, std::int64_t end)
                     {
                         for (std::int64_t i = begin; i < end; ++i)
                         {
                             body(i);
                         }
                     }};
}

/// Short loops over the same items again and again, concurrently: a thread finds in its cache what it left there, and
/// goes from one loop to the next without waiting for the others. The loops must not need each other, nor throw.
template <class... Bodies>
void parallel_runs(const BlockLoop<Bodies>&... loops)
{
    LoopFailure failure;
#pragma omp parallel if ((loops.blocks() + ...) > 1)
    {
        (loops.run_part(failure), ...);
    }
    failure.rethrow();
}

/// Calls body(begin, end) for consecutive blocks of [0, count); blocks run concurrently, in any order. Where an item
/// takes long, smaller blocks give each thread its part. The body must not throw.
template <class Body>
void parallel_blocks(std::int64_t count, Body&& body, std::int64_t block_size = parallel_block)
{
    const BlockLoop<Body&> loop{count, body, block_size};
    const std::int64_t chunk = block_size == parallel_block ? 2 : 1;
    LoopFailure failure;
#pragma omp parallel for schedule(dynamic, chunk) if (loop.blocks() > 1)
    for (std::int64_t block = 0; block < loop.blocks(); ++block)
    {
        failure.guard([&] { loop.run_block(block); });
    }
    failure.rethrow();
}

/// Calls body(i) for every i of [0, count), concurrently. The body must not throw.
template <class Body>
void parallel_for(std::int64_t count, Body&& body)
{
    const auto loop = each(count, [&body](std::int64_t i) { body(i); });
    parallel_blocks(count, loop.body);
}

/// Calls both concurrently. They must not throw.
template <class First, class Second>
void parallel_both(First&& first, Second&& second)
{
    parallel_blocks(
        2, [&](std::int64_t which, std::int64_t) { which == 0 ? first() : second(); }, 1);
}

/// One T for every thread, for scratch memory that outlives a loop.
template <class T>
class PerThread
{
  public:
    /// Of the calling thread; fit() must have been called since the number of threads last grew.
    T& local() { return values_[static_cast<std::size_t>(thread_number())]; }
    /// Call outside of parallel loops.
    void fit() { values_.resize(std::max(values_.size(), static_cast<std::size_t>(thread_count()))); }

  private:
    std::vector<T> values_;
};

/// Folds blocks concurrently, then their results in order: `block_value(begin, end) -> T`, `join(T&, const T&)`.
/// The result does not depend on the number of threads.
template <class T, class BlockValue, class Join>
T parallel_reduce(std::int64_t count, T initial, BlockValue&& block_value, Join&& join,
                  std::int64_t block_size = parallel_block)
{
    static_assert(!std::same_as<T, bool>, "the elements of vector<bool> share bytes, which threads may not");
    std::vector<T> partial(static_cast<std::size_t>(block_count(count, block_size)), initial);
    parallel_blocks(
        count,
        [&](std::int64_t begin, std::int64_t end)
        { partial[static_cast<std::size_t>(begin / block_size)] = block_value(begin, end); },
        block_size);
    T result = initial;
    for (const T& value : partial)
    {
        join(result, value);
    }
    return result;
}

/// Sets `all` to what blocks append concurrently, in the order of the blocks: `append(begin, end, part)`.
template <class T, class Append>
void parallel_list(std::int64_t count, std::vector<T>& all, Append&& append, std::int64_t block_size = parallel_block)
{
    std::vector<std::vector<T>> parts(static_cast<std::size_t>(block_count(count, block_size)));
    parallel_blocks(
        count, [&](std::int64_t begin, std::int64_t end) { append(begin, end, parts[begin / block_size]); },
        block_size);
    std::vector<std::ptrdiff_t> first{0};
    for (const std::vector<T>& part : parts)
    {
        first.push_back(first.back() + std::ssize(part));
    }
    all.resize(static_cast<std::size_t>(first.back()));
    constexpr std::int64_t parts_at_a_time = 16;
    parallel_blocks(
        std::ssize(parts),
        [&](std::int64_t begin, std::int64_t end)
        {
            for (std::int64_t k = begin; k < end; ++k)
            {
                std::copy(parts[k].begin(), parts[k].end(), all.begin() + first[k]);
            }
        },
        parts_at_a_time);
}

/// sum_i value(i), in a fixed order.
template <class Value>
double parallel_sum(std::int64_t count, Value&& value)
{
    return parallel_reduce(
        count, 0.0,
        [&](std::int64_t begin, std::int64_t end)
        {
            double sum = 0.0;
            for (std::int64_t i = begin; i < end; ++i)
            {
                sum += value(i);
            }
            return sum;
        },
        [](double& total, double part) { total += part; });
}

} // namespace corticle

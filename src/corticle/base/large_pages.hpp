// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdlib>
#include <new>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace corticle
{

/// Asks the system for pages of 2 MiB where an array is that large: one that is read from end to end at every step then
/// costs 500 times fewer translations of addresses, a tenth of the time of a pair pass (docs/performance.md).
template <class T>
struct LargePages
{
    using value_type = T;

    LargePages() = default;
    template <class Other>
    LargePages(const LargePages<Other>& /*other*/)
    {
    }

    T* allocate(std::size_t count)
    {
        constexpr std::size_t page = std::size_t{2} << 20;
        constexpr std::size_t line = 64;
        const std::size_t bytes = count * sizeof(T);
        const std::size_t alignment = bytes >= page ? page : line;
        void* memory = std::aligned_alloc(alignment, (bytes + alignment - 1) / alignment * alignment);
        if (memory == nullptr)
        {
            throw std::bad_alloc();
        }
#ifdef __linux__
        if (bytes >= page)
        {
            madvise(memory, bytes, MADV_HUGEPAGE); // a wish: without it the pages are small
        }
#endif
        return static_cast<T*>(memory);
    }
    void deallocate(T* memory, std::size_t /*count*/)
    {
        std::free(memory);
    }

    friend bool operator==(const LargePages& /*a*/, const LargePages& /*b*/)
    {
        return true;
    }
};

template <class T>
using LargeVector = std::vector<T, LargePages<T>>;

} // namespace corticle

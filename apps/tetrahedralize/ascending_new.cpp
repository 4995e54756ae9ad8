// SPDX-License-Identifier: GPL-3.0-or-later
#include "ascending_new.hpp"

#include <sys/mman.h>

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

// `new` and `delete` of the whole program, its libraries included: malloc and free but after make_new_ascend. Clang's
// thread sanitizer brings its own, which cannot be replaced: there addresses do not ascend.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define CORTICLE_NEW_IS_TAKEN
#endif
#endif

#ifdef CORTICLE_NEW_IS_TAKEN

void corticle::make_new_ascend() {}

#else

namespace
{

constexpr std::size_t largest_block = 4096;
constexpr std::size_t alignment = alignof(std::max_align_t);

/// Address space that memory fills as it is written to; empty but after make_new_ascend.
struct Arena
{
    char* begin = nullptr;
    char* next = nullptr;
    char* end = nullptr;

    void* take(std::size_t size)
    {
        const std::size_t rounded = size == 0 ? alignment : (size + alignment - 1) / alignment * alignment;
        if (rounded > static_cast<std::size_t>(end - next))
        {
            throw std::bad_alloc();
        }
        void* const block = next;
        next += rounded;
        return block;
    }
    bool holds(const void* block) const { return block >= begin && block < end; }
};

Arena arena;

} // namespace

void* operator new(std::size_t size)
{
    if (arena.begin != nullptr && size <= largest_block)
    {
        return arena.take(size);
    }
    for (;;)
    {
        if (void* const block = std::malloc(size == 0 ? 1 : size))
        {
            return block;
        }
        const std::new_handler handler = std::get_new_handler();
        if (handler == nullptr)
        {
            throw std::bad_alloc();
        }
        handler();
    }
}

void* operator new(std::size_t size, const std::nothrow_t&) noexcept
{
    try
    {
        return operator new(size);
    }
    catch (...)
    {
        return nullptr;
    }
}

void operator delete(void* block) noexcept
{
    if (!arena.holds(block))
    {
        std::free(block);
    }
}

void operator delete(void* block, std::size_t) noexcept
{
    operator delete(block);
}

void operator delete(void* block, const std::nothrow_t&) noexcept
{
    operator delete(block);
}

namespace corticle
{

void make_new_ascend()
{
    constexpr std::size_t most = std::size_t{1} << 36;
    void* const same_in_every_process = reinterpret_cast<void*>(std::uintptr_t{1} << 45); // where that is free
    for (std::size_t size = most; size >= std::size_t{1} << 26; size /= 2)
    {
        void* const space = mmap(same_in_every_process, size, PROT_READ | PROT_WRITE,
                                 MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (space != MAP_FAILED)
        {
            arena.begin = arena.next = static_cast<char*>(space);
            const std::size_t kept = size == most ? size : size / 4; // where space is limited, malloc needs some, too
            munmap(arena.begin + kept, size - kept);
            arena.end = arena.begin + kept;
            return;
        }
    }
    throw std::bad_alloc();
}

} // namespace corticle

#endif

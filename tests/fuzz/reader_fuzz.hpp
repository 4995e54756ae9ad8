// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <sys/resource.h>

// What the fuzz tests of readers share. A reader fails when anything but InputError comes out, when its message has
// more than one line, or when one input takes more than two seconds or the process more memory than small files can
// justify.

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CORTICLE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define CORTICLE_SANITIZED 1
#endif
#endif

namespace corticle
{

using Clock = std::chrono::steady_clock;
using Sample = std::pair<std::string, std::string>; ///< kind and bytes

constexpr double longest_parse = 2.0; // [s] for one input

/// Sanitizers reserve address space by the terabyte and cannot live under a limit.
inline void limit_memory()
{
#ifndef CORTICLE_SANITIZED
    constexpr rlim_t bytes =
        rlim_t{1} << 30; // libraries and stacks alone take a few hundred megabytes of address space
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
}

/// Changes, inserts, removes and repeats bytes, and puts in what parsers trip over.
class Mutator
{
  public:
    /// @param awkward words beside numbers that the parser of these files trips over
    Mutator(unsigned seed, std::vector<std::string> awkward) : random_(seed), awkward_(std::move(awkward))
    {
        for (const char* number : {"-1", "0", "99999999999999999999", "4294967295", "2147483648", "1e999", "nan", "inf",
                                   "-", "\n", "18446744073709551615"})
        {
            awkward_.emplace_back(number);
        }
        awkward_.emplace_back(4, '\xff');
        awkward_.emplace_back(8, '\0');
    }

    std::size_t below(std::size_t count)
    {
        return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    std::string mutated(std::string bytes)
    {
        const std::size_t changes = 1 + below(below(4) == 0 ? 30 : 4);
        for (std::size_t i = 0; i < changes; ++i)
        {
            change(bytes);
        }
        return bytes;
    }

  private:
    void change(std::string& bytes)
    {
        const std::size_t at = below(bytes.size() + 1);
        switch (below(7))
        {
        case 0:
            bytes.resize(at);
            break;
        case 1:
            bytes.insert(at, awkward_[below(awkward_.size())]);
            break;
        case 2:
            bytes.erase(at, below(20));
            break;
        case 3:
            bytes.insert(at, bytes.substr(below(bytes.size() + 1), below(200)));
            break;
        case 4:
            replace_number(bytes, at, awkward_[below(awkward_.size())]);
            break;
        default:
            if (at < bytes.size())
            {
                bytes[at] = static_cast<char>(below(256));
            }
        }
    }

    /// Replaces the next run of digits from `at` on.
    static void replace_number(std::string& bytes, std::size_t at, const std::string& text)
    {
        const std::size_t begin = bytes.find_first_of("0123456789", at);
        if (begin != std::string::npos)
        {
            const std::size_t end = bytes.find_first_not_of("0123456789", begin);
            bytes.replace(begin, end == std::string::npos ? end : end - begin, text);
        }
    }

    std::mt19937 random_;
    std::vector<std::string> awkward_;
};

/// True when the reader, called as parse(kind, bytes), behaves on these bytes.
template <class Parse>
bool survives(const Sample& input, Parse&& parse)
{
    const auto start = Clock::now();
    try
    {
        parse(input.first, input.second);
    }
    catch (const InputError& error)
    {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos)
        {
            std::printf("the message has more than one line: %s\n", error.what());
            return false;
        }
    }
    catch (const std::exception& error)
    {
        std::printf("not an InputError: %s\n", error.what());
        return false;
    }
    const double taken = std::chrono::duration<double>(Clock::now() - start).count();
    if (taken > longest_parse)
    {
        std::printf("took %.1f s\n", taken);
    }
    return taken <= longest_parse;
}

/// Feeds damaged samples to a reader for some seconds. 0 when it survives; else 1, and the input is left in a file.
template <class Parse>
int fuzz_reader(double seconds, const std::vector<Sample>& seeds, const std::vector<std::string>& awkward,
                Parse&& parse)
{
    Mutator mutator(20240601, awkward);
    const auto start = Clock::now();
    long iterations = 0;
    while (std::chrono::duration<double>(Clock::now() - start).count() < seconds)
    {
        const Sample& seed = seeds[mutator.below(seeds.size())];
        const Sample input{seed.first, mutator.mutated(seed.second)};
        if (!survives(input, parse))
        {
            put_bytes("fuzz-failure." + input.first, input.second);
            std::printf("iteration %ld: the input is in fuzz-failure.%s\n", iterations, input.first.c_str());
            return 1;
        }
        ++iterations;
    }
    std::printf("%ld iterations\n", iterations);
    return 0;
}

} // namespace corticle

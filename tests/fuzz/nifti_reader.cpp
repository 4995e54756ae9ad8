// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds damaged NIfTI files to the reader. Usage: nifti_reader [seconds]. Fails when anything but InputError comes out,
// or when one input takes more than two seconds or the process more memory than small files can justify.
#include "corticle/io/nifti.hpp"

#include "corticle/base/error.hpp"
#include "io/nifti_samples.hpp"
#include "io/temporary_folder.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <random>

#include <sys/resource.h>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CORTICLE_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer) || __has_feature(memory_sanitizer)
#define CORTICLE_SANITIZED 1
#endif
#endif

namespace corticle
{

namespace
{

using Clock = std::chrono::steady_clock;

constexpr double longest = 2.0; // [s] for one input

/// Sanitizers reserve address space by the terabyte and cannot live under a limit.
void limit_memory()
{
#ifndef CORTICLE_SANITIZED
    constexpr rlim_t bytes = rlim_t{1} << 30;
    const rlimit limit{bytes, bytes};
    ::setrlimit(RLIMIT_AS, &limit);
#endif
}

std::vector<NiftiSample> samples()
{
    std::vector<NiftiSample> result;
    for (const bool wide : {false, true})
    {
        for (const bool swapped : {false, true})
        {
            result.push_back(plain_sample(wide, swapped));
            result.push_back(plain_sample(wide, swapped));
            result.back().data<float>(NiftiType::float32, sample_labels());
            result.back().code(result.back().layout().qform_code, 1);
            result.push_back(plain_sample(wide, swapped));
            result.back().dimensions({2, 3, 2, 2}).data<std::int64_t>(NiftiType::int64, sample_labels());
            result.back().sform({Mat3::diagonal(-1, 1, 2), {1, 2, 3}});
        }
    }
    return result;
}

/// Changes bytes, mostly of the header, to what readers trip over; some files are compressed before or after.
class Mutator
{
  public:
    explicit Mutator(unsigned seed) : random_(seed) {}

    std::size_t below(std::size_t count)
    {
        return count == 0 ? 0 : std::uniform_int_distribution<std::size_t>(0, count - 1)(random_);
    }

    std::string mutated(std::string bytes)
    {
        const bool packed = below(3) == 0;
        if (packed && below(2) == 0)
        {
            bytes = gzip(bytes);
            change_some(bytes);
            return bytes;
        }
        change_some(bytes);
        return packed ? gzip(bytes) : bytes;
    }

  private:
    void change_some(std::string& bytes)
    {
        const std::size_t changes = 1 + below(below(4) == 0 ? 20 : 3);
        for (std::size_t k = 0; k < changes; ++k)
        {
            change(bytes);
        }
    }

    void change(std::string& bytes)
    {
        static const std::vector<std::string> awkward{std::string(8, '\xff'),          std::string(8, '\0'),
                                                      std::string("\x7f\xff"),         std::string("\xff\x7f"),
                                                      std::string("\x7f\x80\0\0", 4),  std::string("\0\0\xc0\x7f", 4),
                                                      std::string("\x7f\xff\xff\xff"), std::string("\x80\0\0\0", 4),
                                                      std::string("\x01\0", 2),        std::string("\x00\x01", 2)};
        const std::size_t at = below(bytes.size() + 1);
        switch (below(8))
        {
        case 0:
            bytes.resize(at);
            break;
        case 1:
            bytes.insert(at, awkward[below(awkward.size())]);
            break;
        case 2:
            bytes.erase(at, below(20));
            break;
        case 3:
        case 4:
        case 5:
        {
            const std::string& value = awkward[below(awkward.size())];
            std::copy_n(value.begin(), std::min(value.size(), bytes.size() - at),
                        bytes.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        }
        default:
            if (at < bytes.size())
            {
                bytes[at] = static_cast<char>(below(256));
            }
        }
    }

    std::mt19937 random_;
};

/// True when the reader behaves on these bytes.
bool survives(const std::string& bytes, std::optional<std::int64_t> volume)
{
    const auto start = Clock::now();
    try
    {
        parse_nifti(bytes, "fuzz.nii", volume);
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
    if (taken > longest)
    {
        std::printf("took %.1f s\n", taken);
    }
    return taken <= longest;
}

int run(double seconds)
{
    limit_memory();
    const std::vector<NiftiSample> seeds = samples();
    Mutator mutator(20240602);
    const auto start = Clock::now();
    long iterations = 0;
    while (std::chrono::duration<double>(Clock::now() - start).count() < seconds)
    {
        const std::string input = mutator.mutated(seeds[mutator.below(seeds.size())].bytes());
        const auto volume = mutator.below(2) == 0 ? std::optional<std::int64_t>(mutator.below(3)) : std::nullopt;
        if (!survives(input, volume))
        {
            put_bytes("fuzz-failure.nii", input);
            std::printf("iteration %ld: the input is in fuzz-failure.nii\n", iterations);
            return 1;
        }
        ++iterations;
    }
    std::printf("%ld iterations\n", iterations);
    return 0;
}

} // namespace

} // namespace corticle

int main(int argc, char** argv)
{
    return corticle::run(argc > 1 ? std::atof(argv[1]) : 10.0);
}

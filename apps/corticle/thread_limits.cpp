// SPDX-License-Identifier: GPL-3.0-or-later
#include "thread_limits.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/text_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <latch>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace corticle
{

std::string thread_shortage(int count)
{
    if (count <= static_cast<int>(std::thread::hardware_concurrency()))
    {
        return {};
    }
    std::latch end(1);
    std::vector<std::thread> threads;
    threads.reserve(static_cast<std::size_t>(std::max(count, 0)));
    std::string reason;
    try
    {
        while (static_cast<int>(threads.size()) < count)
        {
            threads.emplace_back([&end] { end.wait(); });
        }
    }
    catch (const std::system_error& error)
    {
        reason = fmt::format("the system gives {} threads ({}): got {}, expected fewer", threads.size(),
                             error.code().message(), count);
    }
    end.count_down();
    std::ranges::for_each(threads, [](std::thread& thread) { thread.join(); });
    return reason;
}

void require_thread_environment()
{
    constexpr const char* name = "OMP_NUM_THREADS";
    const char* const given = std::getenv(name);
    std::string_view rest = given == nullptr ? "" : given;
    while (!rest.empty()) // a number for each level of nesting, with commas between
    {
        const std::size_t comma = std::min(rest.find(','), rest.size());
        int count = 0;
        if (!formats::to_number(formats::trimmed(rest.substr(0, comma)), count) || count < 1 || count > most_threads)
        {
            throw InputError(
                fmt::format("{} of the environment: got \"{}\", expected 1 to {}", name, given, most_threads));
        }
        if (const std::string shortage = thread_shortage(count); !shortage.empty())
        {
            throw InputError(fmt::format("{} of the environment: {}", name, shortage));
        }
        rest.remove_prefix(std::min(comma + 1, rest.size()));
    }
}

} // namespace corticle

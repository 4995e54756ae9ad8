// SPDX-License-Identifier: GPL-3.0-or-later
// Mutates valid cases and overrides: only InputError may come out of the parser, and soon.
// Usage: case_parser [SECONDS [SEED]]

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/starter.hpp"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>

namespace
{

using namespace corticle;
using Clock = std::chrono::steady_clock;
using Random = std::mt19937_64;

constexpr double longest_seconds = 2.0; // for one input

constexpr std::string_view tokens[] = {
    "[",
    "]",
    "{",
    "}",
    "=",
    ".",
    "\"",
    "'",
    "\"\"\"",
    "#",
    "\n",
    "\r\n",
    ",",
    "-",
    "1e999",
    "nan",
    "-inf",
    "0x",
    "9e18",
    "\\u0000",
    "\\",
    "\xff",
    "\xef\xbb\xbf",
    "true",
    "1979-05-27T07:32:00Z",
    "[[a]]",
    "[geometry]",
    "[expect]",
    "geometry.",
    "a.b.c.d.",
    "= [[[[",
    "spacing_mm = 1",
    "times = [0.1, 0.2]",
    "shape = \"file\"",
    "file = \"x\"",
    std::string_view("\0", 1),
};

std::size_t below(Random& random, std::size_t bound)
{
    return bound == 0 ? 0 : random() % bound;
}

void mutate(std::string& text, Random& random)
{
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = std::min(below(random, 40), text.size() - at);
    switch (below(random, 7))
    {
    case 0: // another byte
        if (at < text.size())
        {
            text[at] = static_cast<char>(random());
        }
        break;
    case 1:
        text.erase(at, length);
        break;
    case 2:
        text = text.substr(0, at) + std::string(tokens[below(random, std::size(tokens))]) + text.substr(at);
        break;
    case 3: // a piece again, somewhere else
        text.insert(below(random, text.size() + 1), std::string(text.substr(at, length)));
        break;
    case 4: // one token many times
    {
        std::string many;
        for (std::size_t i = 0, times = below(random, 3000); i < times; ++i)
        {
            many += tokens[below(random, 2) == 0 ? 0 : 5];
        }
        text = text.substr(0, at) + many + text.substr(at);
        break;
    }
    case 5:
        text = text.substr(0, at) + std::string(tokens[below(random, std::size(tokens))]) + text.substr(at + length);
        break;
    default:
        text.resize(at);
        break;
    }
}

/// Parses; a case that is accepted must survive being written and read again.
void try_input(const std::string& text, const std::vector<std::string>& overrides)
{
    try
    {
        const std::string resolved = config::to_toml(config::parse_case(text, "fuzz.toml", overrides, "/"));
        if (config::to_toml(config::parse_case(resolved, "resolved.toml", {}, "/")) != resolved)
        {
            throw std::logic_error("a resolved case does not read back equal");
        }
    }
    catch (const InputError& error)
    {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos)
        {
            throw std::logic_error("a message of more than one line");
        }
    }
}

int fail(const char* reason, const std::string& text, const std::vector<std::string>& overrides)
{
    std::fprintf(stderr, "failed: %s\n--- case\n%s\n", reason, text.c_str());
    for (const std::string& override_text : overrides)
    {
        std::fprintf(stderr, "--- --set %s\n", override_text.c_str());
    }
    return 1;
}

int fuzz(double seconds, std::uint64_t seed)
{
    Random random(seed);
    const std::string seeds[] = {
        config::starter_case(prepare::Shape::sphere), config::starter_case(prepare::Shape::ellipsoid),
        config::starter_case(prepare::Shape::file), config::to_toml(config::parse_case("", "", {}, "/")),
        "[tissue]\nlayer = \"binary\"\nlambda = 0.75\n"};
    const std::string settings[] = {"time.end=0.5", "output.times=[0.1, 0.2]", "geometry.file=\"a.stl\"",
                                    "geometry.semi_axes_mm=[3, 4, 5]"};
    const auto begin = Clock::now();
    const auto since = [](Clock::time_point from)
    { return std::chrono::duration<double>(Clock::now() - from).count(); };
    std::uint64_t inputs = 0;
    for (; since(begin) < seconds; ++inputs)
    {
        std::string text = seeds[below(random, std::size(seeds))];
        std::vector<std::string> overrides;
        for (std::size_t i = below(random, 8); i > 0; --i)
        {
            mutate(text, random);
        }
        if (below(random, 4) == 0)
        {
            overrides.push_back(settings[below(random, std::size(settings))]);
            mutate(overrides.back(), random);
        }
        const auto start = Clock::now();
        try
        {
            try_input(text, overrides);
        }
        catch (const std::exception& error)
        {
            return fail(error.what(), text, overrides);
        }
        if (since(start) > longest_seconds)
        {
            return fail("it took too long", text, overrides);
        }
    }
    std::printf("%llu inputs, seed %llu\n", static_cast<unsigned long long>(inputs),
                static_cast<unsigned long long>(seed));
    return 0;
}

} // namespace

int main(int argc, char** argv)
{
    return fuzz(argc > 1 ? std::atof(argv[1]) : 10.0, argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
}

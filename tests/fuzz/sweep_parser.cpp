// SPDX-License-Identifier: GPL-3.0-or-later
// Mutates valid sweeps: only InputError of one line may come out of the parser, and soon.
// Usage: sweep_parser [SECONDS [SEED]]

#include "corticle/base/error.hpp"
#include "corticle/study/sweep/sweep_file.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <string_view>

namespace
{

using namespace corticle;
using Clock = std::chrono::steady_clock;
using Random = std::mt19937_64;

constexpr double longest_seconds = 2.0; // for one input

constexpr std::string_view tokens[] = {
    "[",         "]",         "[[axis]]\n", "[[line]]\n", "[set]\n",    "{",     "}",
    "=",         "\"",        "\n",         ",",          "-",          "1e999", "nan",
    "0",         "9e18",      "1000000",    "true",       "solver.cfl", "key",   "values",
    "start",     "stop",      "count",      "step",       "zip",        "names", "log",
    "reference", "measures",  "plots",      "@0.5",       "[[0.1]]",    "\xff",  "geometry.file",
    "\\u0000",   "compare_t", "base",       "1e-300",     "= [[[[",
};

constexpr std::string_view seeds[] = {
    "base = \"b.toml\"\nreference = \"finest\"\nmeasures = [\"gi_hull\", \"gi_hull@0.5\"]\nplots = [\"gi_hull\"]\n"
    "compare_t = 0.5\npictures = false\n[set]\ntissue.mu_cortex = 1.0\n[[axis]]\nkey = \"solver.cfl\"\nvalues = [0.1, "
    "0.2]\n"
    "[[axis]]\nkey = \"geometry.particles\"\nstart = 1000\nstop = 8000\ncount = 4\nspacing = \"log\"\n"
    "[[line]]\naxis = \"solver.cfl\"\nmeasure = \"gi_hull\"\nlabel = \"theory\"\nslope = 1\nintercept = 0.5\n",
    "base = \"b.toml\"\nreference = { solver.cfl = 0.2 }\n[[axis]]\nkey = \"solver.cfl\"\nstart = 0.1\nstop = "
    "0.3\nstep = 0.1\n"
    "zip = \"a\"\n[[axis]]\nkey = \"tissue.layer\"\nvalues = [\"smooth\", \"binary\", \"smooth\"]\nnames = [\"x\", "
    "\"y\", \"z\"]\n"
    "zip = \"a\"\n[[axis]]\nkey = \"geometry.semi_axes_mm\"\nvalues = [[1, 2, 3], [3.0, 2.0, 1.0]]\n"};

std::size_t below(Random& random, std::size_t bound)
{
    return bound == 0 ? 0 : random() % bound;
}

void mutate(std::string& text, Random& random)
{
    const std::size_t at = below(random, text.size() + 1);
    const std::size_t length = std::min(below(random, 40), text.size() - at);
    switch (below(random, 6))
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
        text.insert(at, tokens[below(random, std::size(tokens))]);
        break;
    case 3: // a piece again, somewhere else
        text.insert(below(random, text.size() + 1), std::string(text.substr(at, length)));
        break;
    case 4:
        text.replace(at, length, tokens[below(random, std::size(tokens))]);
        break;
    default: // one token many times
        for (std::size_t i = 0, token = below(random, std::size(tokens)), times = below(random, 2000); i < times; ++i)
        {
            text.insert(std::min(at, text.size()), tokens[token]);
        }
        break;
    }
}

/// Parses; true when the sweep was taken.
bool try_input(const std::string& text)
{
    try
    {
        sweep::parse_sweep(text, "fuzz.toml", "/");
        return true;
    }
    catch (const InputError& error)
    {
        if (std::string_view(error.what()).find('\n') != std::string_view::npos)
        {
            throw std::logic_error("a message of more than one line");
        }
        return false;
    }
}

int fail(const char* reason, const std::string& text)
{
    std::fprintf(stderr, "failed: %s\n--- sweep\n%s\n", reason, text.c_str());
    return 1;
}

int fuzz(double seconds, std::uint64_t seed)
{
    Random random(seed);
    const auto begin = Clock::now();
    const auto since = [](Clock::time_point from)
    { return std::chrono::duration<double>(Clock::now() - from).count(); };
    std::uint64_t inputs = 0;
    std::uint64_t taken = 0;
    for (; since(begin) < seconds; ++inputs)
    {
        std::string text{seeds[below(random, std::size(seeds))]};
        for (std::size_t i = below(random, 6); i > 0; --i)
        {
            mutate(text, random);
        }
        const auto start = Clock::now();
        try
        {
            taken += try_input(text) ? 1 : 0;
        }
        catch (const std::exception& error)
        {
            return fail(error.what(), text);
        }
        if (since(start) > longest_seconds)
        {
            return fail("it took too long", text);
        }
    }
    std::printf("%llu inputs, %llu taken, seed %llu\n", static_cast<unsigned long long>(inputs),
                static_cast<unsigned long long>(taken), static_cast<unsigned long long>(seed));
    return taken > 0 ? 0 : fail("no sweep was taken", std::string(seeds[0]));
}

} // namespace

int main(int argc, char** argv)
{
    return fuzz(argc > 1 ? std::atof(argv[1]) : 10.0, argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <random>

namespace corticle
{

/// Flips one bit of a file after another, at 200 random places. `read` must refuse each in one line that names the
/// file, or give what it gives of the whole file: never another result.
template <class Read>
void expect_no_silent_flip(const std::filesystem::path& file, Read read)
{
    constexpr int flips = 200;
    const std::string bytes = bytes_of(file);
    const auto whole = read(file);
    std::mt19937_64 random(20260101);
    int refused = 0;
    for (int k = 0; k < flips; ++k)
    {
        const std::size_t place = random() % bytes.size();
        std::string damaged = bytes;
        damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
        put_bytes(file, damaged);
        try
        {
            EXPECT_TRUE(read(file) == whole) << "byte " << place << " of " << bytes.size();
        }
        catch (const InputError& error)
        {
            const std::string line = error.what();
            EXPECT_NE(line.find(file.filename().string()), std::string::npos) << line;
            EXPECT_EQ(line.find('\n'), std::string::npos) << line;
            ++refused;
        }
    }
    put_bytes(file, bytes);
    EXPECT_GT(refused, flips / 2);
}

} // namespace corticle

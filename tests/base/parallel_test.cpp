// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/parallel.hpp"

#include <gtest/gtest.h>

#include <new>

namespace corticle
{

TEST(Parallel, AnExceptionLeavesTheLoopAndNotTheProcess)
{
    const auto fails_late = [](std::int64_t i)
    {
        if (i == 4000)
        {
            throw std::bad_alloc();
        }
    };
    EXPECT_THROW(parallel_for(5000, fails_late), std::bad_alloc);
    EXPECT_THROW(parallel_runs(each(5000, fails_late)), std::bad_alloc);
    EXPECT_THROW(parallel_sum(5000,
                              [&](std::int64_t i)
                              {
                                  fails_late(i);
                                  return 1.0;
                              }),
                 std::bad_alloc);
    EXPECT_EQ(parallel_sum(5000, [](std::int64_t) { return 1.0; }), 5000.0);
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/child_process.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <new>
#include <stdexcept>

namespace corticle
{

namespace
{

std::optional<std::string> of_children(const std::string& what)
{
    return in_child_process(
        [&]() -> std::string
        {
            if (what == "crash")
            {
                std::raise(SIGKILL);
            }
            if (what == "memory")
            {
                throw std::bad_alloc();
            }
            if (what == "throw")
            {
                throw std::runtime_error("wrong");
            }
            return what;
        });
}

} // namespace

TEST(ChildProcess, ReturnsWhatTheChildReturnedOrNothing)
{
    EXPECT_EQ(of_children("done"), "done");
    EXPECT_EQ(of_children("throw"), std::nullopt);
    EXPECT_EQ(of_children("crash"), std::nullopt);
    EXPECT_THROW(of_children("memory"), std::bad_alloc);
}

TEST(ChildProcess, SeesACrashAlsoWhereSigchldIsIgnored)
{
    std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(of_children("done"), "done");
    EXPECT_EQ(of_children("crash"), std::nullopt);
    EXPECT_THROW(of_children("memory"), std::bad_alloc);
    EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN) << "the action found is not restored";
}

} // namespace corticle

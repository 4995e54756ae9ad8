// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/child_process.hpp"

#include "corticle/base/error.hpp"

#include <gtest/gtest.h>

namespace corticle
{

namespace
{

ProcessEnd of_shell(const std::string& command, std::string_view input = {})
{
    return run_program({"/bin/sh", "-c", command}, input);
}

} // namespace

TEST(ChildProcess, GivesBackOutputsAndStatus)
{
    const ProcessEnd end = of_shell("cat; echo word >&2; exit 7", "some text");
    EXPECT_EQ(end.output, "some text");
    EXPECT_EQ(end.errors, "word\n");
    EXPECT_EQ(end.status, 7);
    EXPECT_EQ(end.signal, 0);
}

TEST(ChildProcess, NeitherSideWaitsForTheOtherToReadOrWrite)
{
    const std::string much(10'000'000, 'x');
    EXPECT_EQ(of_shell("cat", much).output, much);
    EXPECT_EQ(of_shell("exit 0", much).output, ""); // nothing is read
}

TEST(ChildProcess, SeesACrashAlsoWhereSigchldIsIgnored)
{
    EXPECT_EQ(of_shell("kill -SEGV $$").signal, SIGSEGV);
    std::signal(SIGCHLD, SIG_IGN);
    EXPECT_EQ(of_shell("exit 3").status, 3);
    EXPECT_EQ(of_shell("kill -KILL $$").signal, SIGKILL);
    EXPECT_EQ(std::signal(SIGCHLD, SIG_DFL), SIG_IGN) << "the action found is not restored";
}

TEST(ChildProcess, AProgramThatIsMissingIsAnError)
{
    EXPECT_THROW(run_program({"/no/such/program"}, ""), RunError);
}

} // namespace corticle

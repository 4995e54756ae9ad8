// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/command_process.hpp"

#include "formats/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <csignal>

#include <unistd.h>

namespace corticle
{

namespace
{

ProcessEnd wait_for(sweep::CommandProcess& process)
{
    std::optional<ProcessEnd> end;
    for (int i = 0; i < 3000 && !end; ++i)
    {
        end = process.poll();
        usleep(2000);
    }
    return end.value_or(ProcessEnd{-1, -1, "it did not end", ""});
}

} // namespace

TEST(CommandProcess, TellsStatusAndOutput)
{
    sweep::CommandProcess process({"/bin/sh", "-c", "echo said; echo wrong >&2; exit 3"});
    const ProcessEnd end = wait_for(process);
    EXPECT_EQ(end.status, 3);
    EXPECT_EQ(end.signal, 0);
    EXPECT_EQ(end.output, "said\nwrong\n");
}

TEST(CommandProcess, TellsTheSignal)
{
    sweep::CommandProcess process({"/bin/sh", "-c", "kill -SEGV $$"});
    EXPECT_EQ(wait_for(process).signal, SIGSEGV);
    sweep::CommandProcess sleeping({"/bin/sleep", "60"});
    EXPECT_FALSE(sleeping.poll());
    sleeping.terminate();
    EXPECT_EQ(wait_for(sleeping).signal, SIGTERM);
}

TEST(CommandProcess, KeepsTheEndOfALongOutput)
{
    sweep::CommandProcess process({"/bin/sh", "-c", "head -c 1000000 /dev/zero | tr '\\0' x; echo the end"});
    const ProcessEnd end = wait_for(process);
    EXPECT_EQ(end.output.size(), 4096u);
    EXPECT_TRUE(end.output.ends_with("xthe end\n"));
}

TEST(CommandProcess, ACommandThatIsNotThereEndsWith127)
{
    sweep::CommandProcess process({"/no/such/command"});
    EXPECT_EQ(wait_for(process).status, 127);
}

TEST(CommandProcess, IsEndedWithItsObject)
{
    const TemporaryFolder folder;
    const std::string file = (folder / "id").string();
    pid_t id = 0;
    {
        sweep::CommandProcess process({"/bin/sh", "-c", "echo $$ > " + file + "; exec sleep 60"});
        const sweep::CommandProcess moved = std::move(process);
        for (int i = 0; i < 3000 && id == 0; ++i)
        {
            usleep(2000);
            std::ifstream(file) >> id;
        }
        ASSERT_GT(id, 0);
        EXPECT_EQ(kill(id, 0), 0);
    }
    EXPECT_EQ(kill(id, 0), -1);
}

} // namespace corticle

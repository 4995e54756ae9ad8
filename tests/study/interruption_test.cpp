// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/interruption.hpp"

#include <gtest/gtest.h>

#include <atomic>

#include <sys/wait.h>
#include <unistd.h>

namespace corticle
{

namespace
{

std::atomic<int> caught = 0;

void count(int)
{
    ++caught;
}

struct sigaction action_of(int signal)
{
    struct sigaction action
    {
    };
    sigaction(signal, nullptr, &action);
    return action;
}

} // namespace

TEST(Interruption, EverySignalIsARequestHoweverOftenItComes)
{
    for (const int signal : study::interrupting_signals)
    {
        const study::InterruptionGuard guard;
        EXPECT_FALSE(study::InterruptionGuard::requested());
        raise(signal);
        EXPECT_TRUE(study::InterruptionGuard::requested());
        raise(signal);
        raise(signal);
    }
}

TEST(Interruption, RestoresTheHandlersItFound)
{
    const struct sigaction before = action_of(SIGINT);
    std::signal(SIGINT, count);
    std::signal(SIGUSR1, SIG_IGN);
    caught = 0;
    {
        const study::InterruptionGuard guard;
        raise(SIGINT);
        EXPECT_EQ(caught, 0);
    }
    raise(SIGINT);
    EXPECT_EQ(caught, 1);
    EXPECT_EQ(action_of(SIGUSR1).sa_handler, SIG_IGN);
    std::signal(SIGUSR1, SIG_DFL);
    sigaction(SIGINT, &before, nullptr);
}

TEST(Interruption, AHangupThatIsIgnoredStaysSo)
{
    std::signal(SIGHUP, SIG_IGN);
    {
        const study::InterruptionGuard guard;
        raise(SIGHUP);
        EXPECT_FALSE(study::InterruptionGuard::requested());
    }
    std::signal(SIGHUP, SIG_DFL);
}

TEST(Interruption, ASecondCtrlCASecondLaterEndsTheProcess)
{
    const pid_t child = fork();
    if (child == 0)
    {
        const study::InterruptionGuard guard;
        raise(SIGINT);
        raise(SIGTERM);
        usleep(1'100'000);
        raise(SIGTERM);
        raise(SIGINT);
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == SIGINT);
}

} // namespace corticle

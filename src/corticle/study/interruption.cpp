// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/interruption.hpp"

#include <atomic>
#include <cerrno>
#include <cstdint>
#include <ctime>

#include <unistd.h>

namespace corticle::study
{

namespace
{

constexpr std::int64_t impatience_ms = 1000; ///< two Ctrl-C closer to each other than this are one
constexpr int interrupted_status = 130;

// A signal handler can reach nothing but globals of such types.
std::atomic<bool> interruption_requested = false;
std::atomic<std::int64_t> first_ctrl_c_ms = 0;
static_assert(std::atomic<bool>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free);

std::int64_t now_ms()
{
    timespec now{};
    clock_gettime(CLOCK_MONOTONIC, &now);
    return 1000 * static_cast<std::int64_t>(now.tv_sec) + now.tv_nsec / 1'000'000 + 1; // never 0
}

void request_interruption(int signal)
{
    const int kept = errno;
    interruption_requested = true;
    std::int64_t first = 0;
    if (signal == SIGINT && !first_ctrl_c_ms.compare_exchange_strong(first, now_ms()) &&
        now_ms() - first >= impatience_ms)
    {
        std::signal(SIGINT, SIG_DFL);
        kill(getpid(), SIGINT);
    }
    errno = kept;
}

void exit_interrupted(int)
{
    _exit(interrupted_status);
}

bool is_ignored(int signal)
{
    struct sigaction now
    {
    };
    return sigaction(signal, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

/// Sets the handler of all interrupting signals, but for a hangup that is ignored; returns those found.
std::array<struct sigaction, interrupting_signals.size()> handle(void (*handler)(int))
{
    std::array<struct sigaction, interrupting_signals.size()> found{};
    struct sigaction action
    {
    };
    action.sa_handler = handler;
    action.sa_flags = SA_RESTART;
    sigemptyset(&action.sa_mask);
    for (std::size_t i = 0; i < found.size(); ++i)
    {
        const int signal = interrupting_signals[i];
        sigaction(signal, signal == SIGHUP && is_ignored(signal) ? nullptr : &action, &found[i]);
    }
    return found;
}

} // namespace

InterruptionGuard::InterruptionGuard()
{
    interruption_requested = false;
    first_ctrl_c_ms = 0;
    found_ = handle(request_interruption);
}

InterruptionGuard::~InterruptionGuard()
{
    for (std::size_t i = 0; i < found_.size(); ++i)
    {
        sigaction(interrupting_signals[i], &found_[i], nullptr);
    }
}

bool InterruptionGuard::requested()
{
    return interruption_requested;
}

void exit_when_interrupted()
{
    handle(exit_interrupted);
}

void reset_interrupting_signals()
{
    for (const int signal : interrupting_signals)
    {
        if (!is_ignored(signal))
        {
            std::signal(signal, SIG_DFL);
        }
    }
}

} // namespace corticle::study

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include <csignal>

namespace corticle::study
{

/// Signals by which people, terminals and batch systems ask a process to end.
inline constexpr std::array interrupting_signals{SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGXCPU};

/// While it lives, these signals set a flag instead of ending the process. However often they come they are one
/// request; only a second Ctrl-C, a second or more after the first, ends the process at once. A hangup that was ignored
/// (nohup) stays so. The handlers found are restored.
class InterruptionGuard
{
  public:
    InterruptionGuard();
    ~InterruptionGuard();
    InterruptionGuard(const InterruptionGuard&) = delete;
    InterruptionGuard& operator=(const InterruptionGuard&) = delete;

    static bool requested();

  private:
    std::array<struct sigaction, interrupting_signals.size()> found_{};
};

/// From now on these signals end the process with the exit status of an interrupted command (130), outside of guards.
void exit_when_interrupted();

/// In a forked child, before exec: these signals have their default effect; those that are ignored stay so.
void reset_interrupting_signals();

} // namespace corticle::study

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/interruption.hpp"

#include <csignal>

namespace corticle
{

namespace
{

// A signal handler can reach nothing but a global of this type.
volatile std::sig_atomic_t interruption_requested = 0;

void request_interruption(int signal)
{
    interruption_requested = 1;
    std::signal(signal, SIG_DFL);
}

} // namespace

InterruptionGuard::InterruptionGuard()
{
    interruption_requested = 0;
    std::signal(SIGINT, request_interruption);
    std::signal(SIGTERM, request_interruption);
}

InterruptionGuard::~InterruptionGuard()
{
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
}

bool InterruptionGuard::requested()
{
    return interruption_requested != 0;
}

} // namespace corticle

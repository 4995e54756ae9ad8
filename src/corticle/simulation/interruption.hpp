// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle
{

/// While it lives, SIGINT and SIGTERM set a flag instead of ending the process; a second one ends it.
class InterruptionGuard
{
  public:
    InterruptionGuard();
    ~InterruptionGuard();
    InterruptionGuard(const InterruptionGuard&) = delete;
    InterruptionGuard& operator=(const InterruptionGuard&) = delete;

    static bool requested();
};

} // namespace corticle

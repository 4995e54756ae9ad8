// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/child_process.hpp"

#include <optional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace corticle::sweep
{

/// A command that runs beside this process, in a process group of its own, so that Ctrl-C reaches only this process.
/// It gets SIGTERM when this process ends in whatever way. To be started from the main thread, while WaitableChildren
/// live.
class CommandProcess
{
  public:
    /// @param words  the command and its arguments
    /// @throws RunError when it cannot be started
    explicit CommandProcess(const std::vector<std::string>& words);
    CommandProcess(CommandProcess&& other) noexcept;
    CommandProcess& operator=(CommandProcess&& other) noexcept;
    /// Ends it at once if it still runs.
    ~CommandProcess();

    /// How it ended, `output` the end of both its outputs; nothing while it runs.
    std::optional<ProcessEnd> poll();
    /// Asks it to end (SIGTERM).
    void terminate() const;

  private:
    pid_t id_ = -1;
    int output_ = -1;
};

} // namespace corticle::sweep

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <functional>
#include <optional>
#include <string>

namespace corticle
{

/// While it lives, ended children can be waited for, also in a process that was started with SIGCHLD ignored, where the
/// system forgets how they ended. The action found is restored.
class WaitableChildren
{
  public:
    WaitableChildren();
    ~WaitableChildren();
    WaitableChildren(const WaitableChildren&) = delete;
    WaitableChildren& operator=(const WaitableChildren&) = delete;

  private:
    struct sigaction found_
    {
    };
};

/// Runs `work` in a child of this process, silent, and returns what it returned; nothing when it crashed or threw.
/// For libraries that keep state from call to call, print, change the number of threads or may crash: here each call is
/// the first one. The child dies with this process. Call outside of parallel loops and before this process starts
/// threads of its own, above all those of the renderer: the child has none of them, but the locks they hold stay held.
/// In the child, work on one thread only.
/// @throws std::bad_alloc when the child ran out of memory
std::optional<std::string> in_child_process(const std::function<std::string()>& work);

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <csignal>
#include <string>
#include <string_view>
#include <vector>

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

/// How a process ended.
struct ProcessEnd
{
    int status = 0;     ///< exit status; meaningless where a signal ended it
    int signal = 0;     ///< 0: it ended by itself
    std::string output; ///< what it wrote to standard output
    std::string errors; ///< what it wrote to standard error
};

/// Runs a program to its end, `input` its standard input. It has a process group of its own, so that Ctrl-C reaches
/// only this process. Safe whatever threads this process has.
/// @param words  the path of the program, and its arguments
/// @throws RunError when it cannot be started
ProcessEnd run_program(const std::vector<std::string>& words, std::string_view input);

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace corticle
{

/// Bad usage or input. The message is one line: what, where, got, expected. The command exits with status 2.
class InputError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

/// Where a run failed; the message says the same in words.
struct RunPlace
{
    std::int64_t step = -1;                              ///< number of the step that was tried; -1: none
    double t = std::numeric_limits<double>::quiet_NaN(); ///< growth time there [-]; NaN: none
    std::int64_t node = -1;                              ///< particle or node that is invalid; -1: no one of them
};

/// A run that failed. The message holds the diagnosis. The command exits with status 3.
class RunError : public std::runtime_error
{
  public:
    explicit RunError(const std::string& message, const RunPlace& place = {})
        : std::runtime_error(message), place_(place)
    {
    }
    const RunPlace& place() const { return place_; }

  private:
    RunPlace place_;
};

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

/// A run that failed. The message holds the diagnosis. The command exits with status 3.
class RunError : public std::runtime_error
{
  public:
    using std::runtime_error::runtime_error;
};

} // namespace corticle

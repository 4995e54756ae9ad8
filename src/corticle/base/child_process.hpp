// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

namespace corticle
{

/// Runs `work` in a child of this process, silent, and returns what it returned; nothing when it crashed or threw.
/// For libraries that keep state from call to call, print, change the number of threads or may crash: here each call is
/// the first one. Call outside of parallel loops; in the child, work on one thread only.
std::optional<std::string> in_child_process(const std::function<std::string()>& work);

} // namespace corticle

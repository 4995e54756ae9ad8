// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

namespace corticle::view
{

/// Makes DISPLAY name an X server that can draw (GLX): the one it names already, else an Xvfb started for this process
/// alone. Xvfb ends with this process, also when the process is killed. The first call decides for all; later ones are
/// free. False, with what is missing and how to get it in `reason`, when there is none. Call it from a thread that
/// lives as long as the pictures are drawn (the main thread).
bool ensure_display(std::string& reason);

/// @throws RunError naming `png` when nothing can be drawn.
void require_display(const std::filesystem::path& png);

} // namespace corticle::view

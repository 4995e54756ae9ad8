// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/pictures.hpp"

namespace corticle::view
{

// Distinguishable for those who see red and green alike: M. Okabe and K. Ito (2008).
inline constexpr std::array<std::array<unsigned char, 3>, 7> curve_colors{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {86, 180, 233}, {230, 159, 0}, {60, 60, 60}}};

/// Line plots as lines and letters: PDF where the name ends so, else SVG. Needs no display.
/// @throws RunError when it cannot be written
void write_vector_plot(const std::filesystem::path& file, std::span<const Panel> panels, const std::string& title);

} // namespace corticle::view

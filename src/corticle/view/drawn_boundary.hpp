// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/vtk_files.hpp"

namespace corticle::view
{

/// The boundary between cortex and white matter as it is drawn, one point below each vertex [mm]: the array
/// `cortex_boundary` of a surface file, evened out over the neighbours; empty where the file has none.
///
/// The array carries one material point for each vertex and scatters by a tenth of the spacing and more. A plane that
/// meets the boundary at a small angle, as the medial ones do, turns this into a ragged line. Where there is no
/// cortical plate the boundary is the surface itself and stays.
std::vector<Vec3> drawn_boundary(const formats::SurfaceFile& surface);

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::formats
{

/// What becomes of the coordinates of a file whose metadata describe how to get to the scanner's: the matrices of
/// GIFTI, FreeSurfer's volume geometry, the unit of length of NIfTI.
enum class Coordinates
{
    scanner, ///< they are applied
    file     ///< the numbers are taken as they are
};

} // namespace corticle::formats

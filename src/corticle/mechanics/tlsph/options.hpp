// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

namespace corticle::tlsph
{

struct TlsphOptions
{
    double support = 2.3;   ///< support radius of the kernel [spacings]
    double kernel_mm = 0.0; ///< > 0: support radius in mm instead, of pairs whatever lies between them
    double zeta = 0.02;     ///< strength of the zero-energy (hourglass) control [-]
};

/// How much stronger the control is in fine clouds. Compressed beyond Biot's strain a free surface crumples at every
/// scale that the cloud knows, the finest first; the coarser ones of up to three spacings through the cortex cannot.
/// @param spacings  through the cortex
inline double control_of_fine_clouds(double spacings)
{
    const double ratio = spacings / 3.0;
    return std::clamp(ratio * ratio * ratio * ratio, 1.0, 5.0);
}

/// Support radius of the kernel [mm] of a cloud with this spacing [mm].
inline double support_mm(const TlsphOptions& options, double spacing)
{
    return options.kernel_mm > 0.0 ? options.kernel_mm : options.support * spacing;
}

} // namespace corticle::tlsph

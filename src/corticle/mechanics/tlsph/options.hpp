// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::tlsph
{

struct TlsphOptions
{
    double support = 2.3;   ///< support radius of the kernel [spacings]
    double kernel_mm = 0.0; ///< > 0: support radius in mm instead, of pairs whatever lies between them
    double zeta = 0.02;     ///< strength of the zero-energy (hourglass) control [-]
};

/// Support radius of the kernel [mm] of a cloud with this spacing [mm].
inline double support_mm(const TlsphOptions& options, double spacing)
{
    return options.kernel_mm > 0.0 ? options.kernel_mm : options.support * spacing;
}

} // namespace corticle::tlsph

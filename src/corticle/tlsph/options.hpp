// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle
{

struct TlsphOptions
{
    double support = 2.3; ///< support radius of the kernel [spacings]
    double zeta = 0.1;    ///< zero-energy control [-]
};

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle
{

struct ContactOptions
{
    bool enabled = true;
    double distance = 0.3;  ///< dhat: surfaces closer than this repel [spacings]
    double stiffness = 0.1; ///< k in units of m_eff / dt²
};

} // namespace corticle

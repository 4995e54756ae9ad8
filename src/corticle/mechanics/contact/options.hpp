// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::contact
{

struct ContactOptions
{
    bool enabled = true;
    double distance = 0.3;  ///< dhat: surfaces closer than this repel [spacings]
    double stiffness = 0.5; ///< of a pair at its gap, in units of m (c_p / h)²
};

} // namespace corticle::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/body.hpp"

namespace corticle
{

void set_layer(Body& body, double t)
{
    body.tissue.set_layer(t);
    if (body.fem)
    {
        body.fem->tissue.set_layer(t);
    }
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/response.hpp"

#include <fmt/format.h>

namespace corticle
{

std::string describe_particle(const Particles& particles, const Tissue& tissue, std::int64_t i, const Vec3& x,
                              const Mat3& F)
{
    return fmt::format("particle {}: {}, {} neighbours", i,
                       describe_point(x, particles.X[i], tissue.fields.depth[i], F), particles.pairs.size(i));
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/tlsph/response.hpp"

#include <fmt/format.h>

namespace corticle::tlsph
{

std::string describe_particle(const Particles& particles, const material::Tissue& tissue, std::int64_t i, const Vec3& x,
                              const Mat3& F)
{
    return fmt::format("particle {}: {}, {} neighbours", i,
                       mechanics::describe_point(x, particles.X[i], tissue.fields.depth[i], F),
                       particles.pairs.size(i));
}

} // namespace corticle::tlsph

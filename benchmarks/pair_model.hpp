// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/tlsph/pair_law.hpp"

// What the two passes read, write and compute, counted off pair_law.hpp and solver.cpp of mechanics/tlsph. To be
// kept in step with them, and with the table of docs/performance.md.

namespace corticle::bench
{

/// Bytes that must come from memory or go there when nothing but the neighbours' records stays in a cache, and
/// operations (an addition or a multiplication is one, a fused one two). Padding of a Vec3 counts as bytes, not as
/// operations.
struct PassModel
{
    double bytes_per_pair;
    double bytes_per_particle;
    double operations_per_pair;
    double operations_per_particle;

    double bytes(double particles, double pairs) const
    {
        return bytes_per_particle * particles + bytes_per_pair * pairs;
    }
    double operations(double particles, double pairs) const
    {
        return operations_per_particle * particles + operations_per_pair * pairs;
    }
};

inline constexpr double pair_bytes = sizeof(std::uint16_t) + sizeof(float); ///< place and weight
inline constexpr double table_share = 2.7; ///< entries of the tables of neighbours over particles, at 57 neighbours

/// F, stress, force record. Per pair: 13 numbers weighted and added. Per entry of a table: x X^T 9, |x|² 5, origins 6.
/// Per particle it reads X, x, L, b, normal, V, theta, regional rate and the range of its pairs, and writes the record
/// and its own force.
inline constexpr PassModel deformation_pass{
    pair_bytes, 5 * sizeof(Vec3) + sizeof(Mat3) + 4 * sizeof(double) + sizeof(tlsph::ForceRecord), 26.0,
    500.0 + 20.0 * table_share};

/// Forces of the neighbours. Per pair: 13 numbers weighted and added. Per entry of a table: M X + zeta x 24, origins 6.
/// Per particle it reads X, the record and the range of its pairs, and reads and writes the force.
inline constexpr PassModel force_pass{pair_bytes,
                                      sizeof(Vec3) + sizeof(tlsph::ForceRecord) + sizeof(double) + 2 * sizeof(Vec3),
                                      26.0, 24.0 + 30.0 * table_share};

inline constexpr PassModel both_passes{deformation_pass.bytes_per_pair + force_pass.bytes_per_pair,
                                       deformation_pass.bytes_per_particle + force_pass.bytes_per_particle,
                                       deformation_pass.operations_per_pair + force_pass.operations_per_pair,
                                       deformation_pass.operations_per_particle + force_pass.operations_per_particle};

} // namespace corticle::bench

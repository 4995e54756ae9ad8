// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/mechanics/tlsph/enriched_gradient.hpp"
#include "corticle/mechanics/tlsph/options.hpp"
#include "corticle/mechanics/tlsph/pair_blocks.hpp"
#include "corticle/mesh/cloud.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::tlsph
{

/// The meshless discretisation of a cloud in the reference configuration: pairs, weights and gradient corrections.
struct Particles
{
    std::vector<Vec3> X;        ///< reference positions [mm]
    std::vector<double> volume; ///< V [mm³]
    PairBlocks pairs; ///< with the weights w_ij = V_i V_j omega_ij. Rounding a weight to float only redefines the
                      ///< kernel by 1e-7: every identity of the method holds to double precision.
    LargeVector<Mat3> correction;   ///< L_i = (sum_j w_ij X_ij X_ij^T)^-1
    std::vector<Vec3> weighted_sum; ///< b_i = sum_j w_ij X_ij; its fourth lane holds sum_j w_ij
    EnrichedGradients enriched;     ///< of the particles near the surface
    TlsphOptions options;
    double spacing = 0.0; ///< [mm]
};

/// Condition number (largest over smallest eigenvalue) above which a shape matrix is refused.
inline constexpr double largest_condition = 100.0;

/// Weights and gradient corrections of a cloud.
/// @throws InputError naming the worst particle when a shape matrix is ill-conditioned (above largest_condition).
Particles make_particles(const Cloud& cloud, const Neighbors& neighbors, const TlsphOptions& options);

/// What each block of partition_block particles costs in a step, in pairs.
std::vector<double> block_costs(const Particles& particles);

/// Ratio of the largest to the smallest eigenvalue of a symmetric positive matrix; infinite when it is not positive.
double condition_number(const Mat3& symmetric);

} // namespace corticle::tlsph

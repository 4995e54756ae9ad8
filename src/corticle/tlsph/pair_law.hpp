// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/lanes.hpp"
#include "corticle/base/mat3.hpp"

#include <cstdint>

// Sums over the neighbours of one particle. They know neither threads nor materials. Symbols as in
// docs/theory/tlsph.md.

namespace corticle
{

/// The neighbours j of one particle i.
struct NeighborRange
{
    const std::int32_t* index; ///< j
    const float* weight;       ///< w_ij = V_i V_j omega_ij
    std::int64_t count;
};

/// What the deformation pass needs of the pairs of one particle.
struct DeformationSums
{
    Mat3 moment;                 ///< sum_j w_ij x_ij X_ij^T; times L_i it is F_i
    Vec3 weighted_sum;           ///< sum_j w_ij x_ij
    double squared_lengths = 0.; ///< sum_j w_ij |x_ij|²
};

/// @param X  reference positions [mm]   @param x  current positions [mm]
CORTICLE_INLINE DeformationSums sum_deformation(std::int64_t i, const NeighborRange& neighbors, const Vec3* X,
                                                const Vec3* x)
{
    const Lanes X_i = lanes(X[i]);
    const Lanes x_i = lanes(x[i]);
    Lanes column_x{};
    Lanes column_y{};
    Lanes column_z{};
    Lanes sum{};
    Lanes squares{};
    for (std::int64_t k = 0; k < neighbors.count; ++k)
    {
        const std::int32_t j = neighbors.index[k];
        const Lanes X_ij = lanes(X[j]) - X_i;
        const Lanes x_ij = lanes(x[j]) - x_i;
        const Lanes weighted = static_cast<double>(neighbors.weight[k]) * x_ij;
        column_x += X_ij[0] * weighted;
        column_y += X_ij[1] * weighted;
        column_z += X_ij[2] * weighted;
        sum += weighted;
        squares += weighted * x_ij;
    }
    DeformationSums result;
    result.moment = {{{column_x[0], column_x[1], column_x[2]},
                      {column_y[0], column_y[1], column_y[2]},
                      {column_z[0], column_z[1], column_z[2]}}};
    result.weighted_sum = {sum[0], sum[1], sum[2]};
    result.squared_lengths = squares[0] + squares[1] + squares[2];
    return result;
}

/// What the force pass reads of a neighbour: two cache lines.
struct alignas(64) ForceRecord
{
    Mat3 M; ///< V_i P_i L_i - zeta_i F_i
    Vec3 x; ///< current position [mm]; its fourth lane holds zeta_i
};

/// sum_j w_ij (M_j X_ij + zeta_j x_ij), the part of the force on particle i that its neighbours' states make.
CORTICLE_INLINE Vec3 sum_force(std::int64_t i, const NeighborRange& neighbors, const Vec3* X,
                               const ForceRecord* records)
{
    const Lanes X_i = lanes(X[i]);
    const Lanes x_i = lanes(records[i].x);
    // Four sums, not one: each waits only for its own last addition.
    Lanes from_x{};
    Lanes from_y{};
    Lanes from_z{};
    Lanes from_zeta{};
    for (std::int64_t k = 0; k < neighbors.count; ++k)
    {
        const std::int32_t j = neighbors.index[k];
        const ForceRecord& record = records[j];
        const double w = static_cast<double>(neighbors.weight[k]);
        const Lanes X_ij = w * (lanes(X[j]) - X_i);
        const Lanes x_j = lanes(record.x);
        from_x += X_ij[0] * lanes(record.M.column[0]);
        from_y += X_ij[1] * lanes(record.M.column[1]);
        from_z += X_ij[2] * lanes(record.M.column[2]);
        from_zeta += (w * x_j[3]) * (x_j - x_i);
    }
    const Lanes force = (from_x + from_y) + (from_z + from_zeta);
    return {force[0], force[1], force[2]};
}

} // namespace corticle

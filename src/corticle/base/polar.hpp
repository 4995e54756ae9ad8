// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

namespace corticle
{

/// Rotation R of the polar decomposition F = R U, U symmetric and positive, for det F > 0: the iteration
/// R <- (s R + R^-T / s) / 2 from R = F, s² = |R^-T| / |R| (Higham 1986). Converges quadratically, to round-off in
/// about eight rounds even where F stretches by a thousand.
inline Mat3 polar_rotation(const Mat3& F)
{
    constexpr int most_rounds = 40;
    constexpr double round_off = 1e-30; // of the squared change, entries are of order 1
    Mat3 R = F;
    for (int round = 0; round < most_rounds; ++round)
    {
        const Mat3 inverse_transpose = (1.0 / determinant(R)) * cofactor(R);
        const double s = std::sqrt(std::sqrt(contract(inverse_transpose, inverse_transpose) / contract(R, R)));
        const Mat3 next = 0.5 * (s * R + (1.0 / s) * inverse_transpose);
        const Mat3 change = next - R;
        R = next;
        if (contract(change, change) < round_off)
        {
            break;
        }
    }
    return R;
}

} // namespace corticle

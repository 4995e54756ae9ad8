// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/remodelled.hpp"
#include "corticle/material/tissue.hpp"

#include <cstddef>

namespace corticle::material
{

/// Histories of all material points, each number in an array of its own; null where it stays as at the start.
template <class Number>
struct HistoryArrays
{
    Number* strain = nullptr; ///< xx of all points, then yy, zz, yz, xz, xy
    Number* growth = nullptr;
    Number* fibre_length = nullptr;
};

/// Histories as the pass over the material points sees them: what it finds, and where it puts what they will be should
/// the step be taken.
struct RemodellingView
{
    RemodellingStep step;
    std::size_t points = 0;
    HistoryArrays<const double> before;
    HistoryArrays<double> after;
};

inline constexpr std::size_t strain_size = 6;
/// Row and column of each number of strain.
inline constexpr int strain_entries[strain_size][2]{{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}};

/// Stress dW/dF at one point of a tissue with a history [mu_w].
/// @param view  histories of the points of `tissue`   @param point  without growth by stress
Mat3 remodelled_stress(const RemodellingView& view, const Tissue& tissue, std::size_t i, const MaterialPoint& point,
                       const Mat3& F);

} // namespace corticle::material

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

namespace corticle::metrics
{

/// Nodes and weights of a Gauss quadrature.
struct Quadrature
{
    std::vector<double> nodes;   ///< ascending
    std::vector<double> weights; ///< sum 1
};

/// The quadrature of a Jacobi matrix (symmetric, tridiagonal): its eigenvalues and the squares of the first components
/// of its eigenvectors (Golub & Welsch 1969, Math. Comp. 23).
/// @param below  entries beside the diagonal, one fewer than the diagonal has
Quadrature gauss_quadrature(const std::vector<double>& diagonal, const std::vector<double>& below);

} // namespace corticle::metrics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/tridiagonal.hpp"

#include <Eigen/Eigenvalues>

namespace corticle::metrics
{

Quadrature gauss_quadrature(const std::vector<double>& diagonal, const std::vector<double>& below)
{
    if (diagonal.empty())
    {
        return {};
    }
    const auto view = [](const std::vector<double>& v)
    { return Eigen::Map<const Eigen::VectorXd>(v.data(), static_cast<Eigen::Index>(v.size())); };
    Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver;
    solver.computeFromTridiagonal(view(diagonal), view(below));
    const Eigen::VectorXd& nodes = solver.eigenvalues();
    const Eigen::VectorXd weights = solver.eigenvectors().row(0).array().square();
    return {{nodes.begin(), nodes.end()}, {weights.begin(), weights.end()}};
}

} // namespace corticle::metrics

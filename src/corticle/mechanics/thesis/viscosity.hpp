// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/thesis/neighbor_sums.hpp"
#include "corticle/mechanics/thesis/options.hpp"

#include <span>
#include <vector>

namespace corticle::thesis
{

/// Artificial viscosity between particles that approach each other (thesis eq. 7), as eq. 9 takes it in:
/// f_i = -sum_j w_ij Pi_ij X_ij, Pi_ij = -alpha c_ij phi_ij + beta phi_ij² where
/// phi_ij = h v_ij . x_ij / (|x_ij|² + 0.01 h²) < 0, else 0. Pi carries the reference density, 1 here, which makes it a
/// stress; c_ij is the mean wave speed of the two, h the support of the kernel. Pairs are summed in single precision.
class ArtificialViscosity
{
  public:
    /// @param wave_speeds  sqrt(K + 4 mu / 3), one per particle   @param h  [mm]   @param origin  amid the body [mm]
    ArtificialViscosity(const ThesisOptions& options, std::span<const double> wave_speeds, double h,
                        const Vec3& origin);

    /// Adds its forces [mu_w mm²]. @return the power it takes from the motion [mu_w mm³ per unit of time]
    /// @param X  reference positions [mm]   @param x  current ones   @param v  [mm per unit of time]
    double add_forces(const NeighborGroups& groups, std::span<const Vec3> X, std::span<const Vec3> x,
                      std::span<const Vec3> v, std::span<Vec3> forces);

  private:
    struct alignas(64) Record
    {
        float x[3], v[3], X[3], half_speed;
    };
    struct Law
    {
        float alpha, beta, h;
    };
    static void add_block(const Law& law, const NeighborGroups& groups, const Record* records, std::int64_t begin,
                          std::int64_t end, Vec3* forces, double& power);

    Law law_;
    Vec3 origin_;
    std::vector<Record> records_;
};

} // namespace corticle::thesis

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace corticle::mechanics
{

/// What one evaluation of the internal forces says about the whole body. A material point is a particle or an element,
/// as the discretisation has it.
struct InternalResponse
{
    double elastic_energy = 0.0;   ///< sum V Psi(F) [mu_w mm³]
    double zero_mode_energy = 0.0; ///< [mu_w mm³]
    double growth_power = 0.0;     ///< dE/dt at fixed positions: work of growth per unit of growth time [mu_w mm³]
    double released = 0.0; ///< energy that the step of the tissue's history takes, less what it puts in [mu_w mm³]
    double stiffest_rate = 0.0; ///< largest wave speed at density 1 over smallest principal stretch, growth included,
                                ///< for points one spacing apart
    double smallest_J = 0.0;    ///< smallest det F
    std::int64_t smallest_J_at = -1;     ///< its material point
    std::int64_t barrier_count = 0;      ///< material points whose barrier acts
    std::int64_t extrapolated_count = 0; ///< elements so flat in one direction that their law is extrapolated
    std::int64_t inverted_count = 0;     ///< elements with det F <= 0, which survive
    std::int64_t invalid_at = -1; ///< first node beside which det F <= 0 (where that is not allowed) or a value is not
                                  ///< finite; -1 when the state is sound
};

/// Adds what one block of material points found to what the blocks before it did.
void join(InternalResponse& total, const InternalResponse& part);

/// "position (1, 2, 3) mm, reference (1, 2, 2.5) mm, depth 0.1 mm, J = 0.5, F = [[...], [...], [...]]"
std::string describe_point(const Vec3& x, const Vec3& X, double depth, const Mat3& F);

/// A body cut into nodes that carry mass and material points that carry stress: says which forces the tissue exerts on
/// its nodes for given positions and growth. The other force terms, the integrator, measures and output know no more of
/// it.
class Discretization
{
  public:
    Discretization() = default;
    Discretization(const Discretization&) = delete;
    Discretization& operator=(const Discretization&) = delete;
    virtual ~Discretization() = default;

    /// Sends the positions that other ranks read of this one's nodes [mm]: evaluate() at the same positions, which must
    /// follow, waits for those of the others and writes them into x. Of ranks that share no work, nothing.
    virtual void exchange_positions(std::span<Vec3> /*x*/) {}

    /// @param x  current positions of the nodes [mm]   @param t  growth time [-]
    /// @param forces  out, one per node [mu_w mm²]: the exact negative gradient of elastic_energy + zero_mode_energy;
    /// not set when the state is invalid
    virtual InternalResponse evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces) = 0;

    /// Adds forces that depend on the velocities v [mm per unit of time], after evaluate at the same positions. Most
    /// have none. @return the power these forces take from the motion [mu_w mm³ per unit of time]
    virtual double add_viscous_forces(std::span<const Vec3> /*x*/, std::span<const Vec3> /*v*/,
                                      std::span<Vec3> /*forces*/)
    {
        return 0.0;
    }

    /// F at every node for given positions of the nodes; where ranks share the work, all call it, and rank 0 alone gets
    /// that of nodes it does not own.
    virtual std::vector<Mat3> deformation_gradients(std::span<const Vec3> x) const = 0;

    /// A node of a material point: the particle itself, or a corner of the element.
    virtual std::int64_t node_of(std::int64_t material_point) const { return material_point; }
    /// Where a material point is now, x being the positions of the nodes [mm].
    virtual Vec3 place_of(std::int64_t material_point, std::span<const Vec3> x) const
    {
        return x[static_cast<std::size_t>(material_point)];
    }

    /// What is known of the material point at fault where `invalid_at` is this node: "particle 12: position ..., J
    /// ...".
    virtual std::string diagnosis(std::int64_t node, std::span<const Vec3> x) const = 0;
};

} // namespace corticle::mechanics

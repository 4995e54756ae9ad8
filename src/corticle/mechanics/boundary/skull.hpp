// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/boundary/options.hpp"
#include "corticle/mechanics/force_term.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::boundary
{

/// Size of the skull over that at the start: linear in t between given times, constant before and after.
class SkullGrowth
{
  public:
    SkullGrowth() = default;
    /// @param times   ascending [t]; none: a size that stays
    SkullGrowth(std::span<const double> times, std::span<const double> scales)
        : times_(times.begin(), times.end()), scales_(scales.begin(), scales.end())
    {
    }
    double scale(double t) const;
    double rate(double t) const; ///< from t on [1/t]

  private:
    std::vector<double> times_;
    std::vector<double> scales_;
};

/// How many times heavier than a vertex of the brain one of a rigid skull is, where contact joins them in a step.
inline constexpr double rigid_mass_ratio = 1e6;

/// The skull: a closed surface around the brain that grows by a law of its own. A rigid one is where its growth says;
/// the vertices of an elastic one are masses, each on a spring to where the growth says. Terms that touch it add to its
/// forces. It is where the last accepted step left it until a step is proposed.
class Skull
{
  public:
    /// @param surface  at the start
    /// @param mass     of a vertex
    /// @param start    growth time at which it has this size [t]
    Skull(const TriangleMesh& surface, const BoundaryOptions& options, double mass, double start);

    std::span<const Triangle> triangles() const { return triangles_; }
    std::span<const Vec3> positions() const { return trial_.x; }
    std::span<Vec3> forces() { return trial_.force; }
    /// In the contact of a step, by which vertices that may not come closer are joined.
    double mass_in_contact() const { return is_elastic_ ? mass_ : rigid_mass_ratio * mass_; }
    double enclosed_volume() const { return corticle::enclosed_volume(trial_.x, triangles_); }

    /// Ways of the vertices in a step from where they were accepted [mm].
    void propose(const dynamics::StepPlan& plan, std::span<Vec3> ways);
    /// Takes these ways.
    void move(std::span<const Vec3> ways, double dt);

    /// Begins an evaluation: sets the forces to those of the springs.
    void begin(const mechanics::StepContext& context);
    /// Ends it, once all forces are there: what the growth of the skull puts in, what the friction of its springs
    /// takes.
    mechanics::Contribution finish(const mechanics::StepContext& context);
    double spring_energy() const { return spring_energy_; }
    double kinetic_energy() const;

    void accept(mechanics::History& history);

  private:
    Vec3 target(std::size_t vertex, double t) const;
    Vec3 target_rate(std::size_t vertex, double t) const;

    std::vector<Triangle> triangles_;
    std::vector<Vec3> rest_;
    Vec3 centre_;
    SkullGrowth growth_;
    bool is_elastic_;
    double mass_;
    std::vector<double> spring_; ///< stiffness of each [mu_w mm]
    double rate_ = 0.0;          ///< friction of the springs, critical [1 / time]
    dynamics::Motion accepted_;
    dynamics::Motion trial_;
    double spring_energy_ = 0.0;
};

} // namespace corticle::boundary

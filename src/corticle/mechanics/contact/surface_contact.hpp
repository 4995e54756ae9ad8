// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"
#include "corticle/mechanics/contact/barrier.hpp"
#include "corticle/mechanics/contact/near_pairs.hpp"
#include "corticle/mechanics/contact/options.hpp"
#include "corticle/mechanics/contact/travel_limit.hpp"

#include <algorithm>
#include <optional>

namespace corticle
{

/// What one evaluation of the contact forces tells.
struct ContactResponse
{
    std::int64_t active = 0; ///< vertices and edges that repel
    /// Largest frequency of the vertices on the springs that their pairs are now, from above [1 / time].
    double largest_rate = 0.0;
};

/// Self-contact of a closed surface: vertex against triangle and edge against edge, on current positions.
///
/// Every vertex repels the triangle closest to it, and every edge the edge closest to it, where the distance is below
/// the gap of that vertex or edge (`Barrier`). The energy is a function of the distances to the closest alone, so it
/// is continuous wherever another becomes the closest, and the forces are minus its gradient. The gap is dhat, or the
/// distance in the reference where that is smaller: rest is free of contact stress.
/// `hold_apart` sees to it that no two parts cross, whatever the forces are.
class SurfaceContact
{
  public:
    /// @param rest      reference positions of the surface vertices [mm]
    /// @param masses    of the vertices
    /// @param spacing   particle spacing h [mm]
    /// @param frequency wave speed over spacing: a spring of stiffness m · frequency² is about as stiff as the tissue
    ///                  [1 / time]
    SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest, std::vector<double> masses,
                   double spacing, double frequency, const ContactOptions& options);

    /// Adds the contact forces at positions x to `forces` (both per surface vertex).
    ContactResponse evaluate(std::span<const Vec3> x, std::span<Vec3> forces);

    /// Sum of the barriers at the positions last evaluated: a potential [mu_w mm³].
    double energy() const;

    /// Whether no two parts come closer than is safe where no vertex moves farther than `longest` [mm] from the
    /// positions last evaluated.
    bool stays_apart(double longest) const { return travel_limit_->stays_apart(near_, least_distance(), longest); }
    /// Changes displacements [mm] of vertices from the positions last evaluated where parts would come closer than is
    /// safe, see TravelLimit. @return the vertices whose displacement has changed, in ascending order
    std::span<const std::int32_t> hold_apart(std::span<Vec3> displacements)
    {
        return travel_limit_->apply(near_, displacements);
    }

    /// Distance below which surfaces repel [mm].
    double activation_distance() const { return near_.range(); }

  private:
    /// Those that repel their closest: the vertices or the edges.
    template <class Pair>
    struct Owners
    {
        std::vector<Barrier> barrier;
        std::array<std::vector<Pair>, 2> closest; ///< near pair of each, in both halves of them; then of all, first
        std::array<double, 2> least{};            ///< distance in both halves of the near pairs [mm]
        std::vector<std::int32_t> repelling;      ///< those whose closest is nearer than their gap, ascending
    };
    struct Push
    {
        std::array<std::int32_t, 4> vertex;
        std::array<double, 4> weight; ///< of the force on each vertex
        Vec3 force;                   ///< on the first part [mu_w mm²]
        double root_stiffness;
    };
    /// What acts on a vertex.
    struct Load
    {
        Vec3 force;
        double root_stiffness = 0.0; ///< r: sum of |w| sqrt(k) of the pushes
    };
    template <class Pair>
    void set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const;
    template <class Pair>
    void choose(const NearPairs::Blocks<Pair>& near, std::size_t half, Owners<Pair>& owners) const;
    template <class Pair>
    void settle(Owners<Pair>& owners) const;
    void find_repelling();
    template <class Pair>
    auto working_out(std::span<const Vec3> x, const Owners<Pair>& owners, Push* pushes) const;
    double least_distance() const;
    void add_up();
    double largest_rate() const;

    NearPairs near_;
    std::vector<double> masses_;
    Owners<VertexTriangle> vertices_;
    Owners<EdgeEdge> edges_;
    std::optional<TravelLimit> travel_limit_; ///< set once the gaps are known
    std::vector<Push> pushes_;
    std::array<std::vector<Load>, 2> loads_; ///< of both halves of the pushes; once added up, the first is of all
};

} // namespace corticle

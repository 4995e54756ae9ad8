// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"
#include "corticle/mechanics/contact/barrier.hpp"
#include "corticle/mechanics/contact/near_pairs.hpp"
#include "corticle/mechanics/contact/options.hpp"
#include "corticle/mechanics/contact/travel_limit.hpp"

#include <algorithm>
#include <optional>
#include <string>

namespace corticle::contact
{

/// Result of one evaluation of the contact forces.
struct ContactResponse
{
    std::int64_t active = 0; ///< vertices and edges that repel
    /// Largest frequency of the vertices on the springs that their pairs are now, from above [1 / time].
    double largest_rate = 0.0;
};

/// Contact of a surface with the wall around it.
struct WallContact
{
    double force = 0.0;                  ///< sum of the magnitudes of all pushes between them [mu_w mm²]
    double energy = 0.0;                 ///< [mu_w mm³]
    std::vector<std::uint8_t> is_pushed; ///< whether each vertex of the surface is; empty without a wall
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
    /// @param places    of the vertices in the positions and forces of a body; as they are numbered where it is empty
    /// @param wall      see SurfaceParts; the barriers of its parts are those of a vertex of the mean mass of the
    /// others
    /// @param share     of the vertices; of a part of them the forces are those of one process, to the bit
    SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest, std::vector<double> masses,
                   double spacing, double frequency, const ContactOptions& options,
                   std::vector<std::int32_t> places = {}, std::int32_t wall = no_wall, SurfaceShare share = {});

    /// Adds the contact forces at positions x to `forces`, both of the body; those on the vertices of the share.
    /// Collective.
    ContactResponse evaluate(std::span<const Vec3> x, std::span<Vec3> forces);

    /// Sum of the barriers at the positions last evaluated: a potential [mu_w mm³]. Collective.
    double energy() const;
    /// Of that evaluation, what is between the surface and its wall.
    WallContact wall_contact() const;

    /// Whether no two parts come closer than is safe in a step of the body from the positions last evaluated.
    /// Collective.
    bool stays_apart(const Travel& travel)
    {
        return !near_.share().any(!travel_limit_->stays_apart(near_, least_distance(), travel, places_));
    }
    /// Changes displacements [mm] of vertices from the positions last evaluated where parts would come closer than is
    /// safe, see TravelLimit. @return the vertices whose displacement has changed, in ascending order. Collective.
    std::span<const std::int32_t> hold_apart(std::span<Vec3> displacements)
    {
        return travel_limit_->apply(near_, displacements);
    }

    /// The pair that the largest rate of the last evaluation comes from, in words: its particles, by their places in
    /// the body, distance, gap and position. Some pair must repel. Collective.
    std::string stiffest_pair() const;

  private:
    /// Those that repel their closest: the vertices or the edges.
    struct Push
    {
        std::array<double, 4> weight; ///< of the force on each vertex
        Vec3 force;                   ///< on the first part [mu_w mm²], and sqrt(k) in the fourth lane
        std::array<std::int32_t, 4> vertex;
    };
    template <class Pair>
    struct Owners
    {
        std::vector<Barrier> barrier;
        /// One bit for each that has a near pair in one half of them, and the closest of these; once joined, the
        /// closest of all is in the first.
        std::array<std::vector<std::uint64_t>, 2> met;
        std::array<std::vector<Pair>, 2> closest;
        std::array<double, 2> least{}; ///< distance in both halves of the near pairs [mm]
        /// Of every block of owners those whose closest is nearer than their gap, in ascending order from the place of
        /// the block's first; and how many.
        std::vector<std::int32_t> repelling;
        std::vector<Push> pushes;
        std::vector<std::int64_t> count;
    };
    template <class Pair>
    void make_room(Owners<Pair>& owners) const;
    template <class Pair>
    void set_gaps(const NearPairs::Blocks<Pair>& near, Owners<Pair>& owners) const;
    template <class Pair>
    void choose(const NearPairs::Blocks<Pair>& near, std::size_t half, Owners<Pair>& owners) const;
    void find_closest();
    template <class Pair>
    std::int64_t settle(std::int64_t begin, std::int64_t end, Owners<Pair>& owners, std::span<Pair> repelling) const;
    template <class Pair>
    auto working_out(Owners<Pair>& owners) const;
    double least_distance() const;
    /// A push, by its block of owners and its number in it.
    struct Place
    {
        std::int64_t block;
        std::int64_t number;
    };
    /// The owner of a push among all: the vertices, then the edges.
    using Owner = std::int64_t;
    bool answers_for(const Owners<VertexTriangle>&, std::int32_t owner) const { return near_.share().has(owner); }
    bool answers_for(const Owners<EdgeEdge>&, std::int32_t owner) const
    {
        const SurfaceShare& share = near_.share(); // not shared, it needs no look at the edge
        return !share.is_part() || share.has(near_.parts().edges()[static_cast<std::size_t>(owner)][0]);
    }
    template <class Pair, class Act>
    void for_own_pushes(const Owners<Pair>& owners, std::int64_t first, std::int64_t last, Act&& act) const;
    std::vector<std::int64_t> count_pushes() const;
    Owner middle_of(std::span<const std::int64_t> counts, std::int64_t half) const;
    template <class Pair>
    static Place place_of(const Owners<Pair>& owners, Owner owner);
    template <class Pair>
    static void add_up(const Owners<Pair>& owners, const Place& from, const Place& to, std::vector<Vec3>& loads);
    void add_up(std::span<const std::int64_t> counts, std::int64_t active);
    double row_of(const Push& push) const;
    void give(std::span<Vec3> forces);
    template <class Pair>
    auto bounding(const Owners<Pair>& owners, std::span<double> largest) const;
    double largest_rate() const;
    template <class Pair>
    void add_wall_contact(const Owners<Pair>& owners, WallContact& sum) const;

    std::int32_t wall_;
    NearPairs near_;
    std::vector<double> masses_;
    std::vector<std::int32_t> places_;
    Owners<VertexTriangle> vertices_;
    Owners<EdgeEdge> edges_;
    std::optional<TravelLimit> travel_limit_; ///< set once the gaps are known
    /// Forces of both halves of the pushes on each vertex, and sum of |w| sqrt(k) in the fourth lane; zero in between.
    std::array<std::vector<Vec3>, 2> loads_;
    std::vector<double> rate_of_vertex_; ///< r over the mass
};

} // namespace corticle::contact

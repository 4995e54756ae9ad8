// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/contact/candidates.hpp"
#include "corticle/contact/options.hpp"

namespace corticle
{

/// What one evaluation of the contact forces tells.
struct ContactResponse
{
    double energy = 0.0;           ///< sum of k (gap - d)² / 2 [mu_w mm³]
    double dissipated_power = 0.0; ///< by the normal damping [mu_w mm³ per unit of time]
    std::int64_t active = 0;       ///< pairs that push
};

/// Self-contact of a closed surface: vertex against triangle and edge against edge, on current positions.
///
/// A pair closer than its gap repels along the line between its closest points with k (gap - d), and is damped
/// critically while it approaches. k = stiffness · m_eff / dt²: as stiff as the step allows, whatever the material.
/// Only the closest triangle of a vertex and the mutually closest edges push. Pairs that are closer than dhat in the
/// reference have that distance as their gap: rest is free of contact stress.
/// No vertex may move in one step more than 0.4 of its distance to the nearest primitive it is no part of
/// (`travel_limit`), so two surfaces cannot cross.
class SurfaceContact
{
  public:
    /// @param rest     reference positions of the surface vertices [mm]
    /// @param masses   of the vertices
    /// @param spacing  particle spacing [mm]
    SurfaceContact(std::span<const Triangle> triangles, std::span<const Vec3> rest, std::vector<double> masses,
                   double spacing, const ContactOptions& options);

    /// Adds the contact forces at positions x with velocities v to `forces` (all per surface vertex) and sets the
    /// travel limits.
    /// @param dt  the step the stiffness is scaled to
    ContactResponse evaluate(std::span<const Vec3> x, std::span<const Vec3> v, double dt, std::span<Vec3> forces);

    /// Largest displacement of each vertex in the next step [mm].
    std::span<const double> travel_limit() const { return travel_limit_; }

    /// Distance below which surfaces repel [mm].
    double activation_distance() const { return dhat_; }

  private:
    /// A near pair that pushes where its closest points allow it.
    template <class Pair>
    struct Pushing
    {
        Pair pair;
        double gap; ///< [mm]
    };
    /// What it pushes with.
    struct Push
    {
        std::array<std::int32_t, 4> vertex;
        std::array<double, 4> weight; ///< of the force on each vertex
        Vec3 force;                   ///< on the first part [mu_w mm²]
        double energy;
        double dissipated_power;
        bool acts;
    };
    /// What is known of candidates, and those of them that are near: closer than dhat now. The path of a pair is the
    /// length of way its two parts have moved: a pair measured once need not be measured again before that has grown by
    /// what it was too far.
    template <class Pair>
    struct Watch
    {
        std::vector<double> gap;             ///< of every vertex, or of every edge [mm]
        std::vector<double> due;             ///< path at which each candidate may be near [mm]
        std::vector<std::vector<Pair>> near; ///< of blocks of the candidates, in their order, with their distance now
        std::vector<double> least; ///< of every part, the distance of its closest near pair; -1 once that is found [mm]
        std::vector<double> travel_limit;   ///< that the near pairs set to each vertex [mm]
        std::vector<Pushing<Pair>> pushing; ///< those of the near pairs that may push
    };
    std::array<std::int32_t, 4> vertices_of(const VertexTriangle& pair) const;
    std::array<std::int32_t, 4> vertices_of(const EdgeEdge& pair) const;
    std::array<std::int32_t, 2> parts_of(const VertexTriangle& pair) const;
    std::array<std::int32_t, 2> parts_of(const EdgeEdge& pair) const;
    template <class Pair>
    void set_gaps(std::span<const Pair> pairs, Watch<Pair>& watched) const;
    template <class Pair>
    auto watching(std::span<const Pair> pairs, Watch<Pair>& watched) const;
    template <class Pair>
    auto measuring(std::span<const Vec3> x, std::span<const Pair> pairs, Watch<Pair>& watched) const;
    double path_of(const VertexTriangle& pair) const;
    double path_of(const EdgeEdge& pair) const;
    bool follow(std::span<const Vec3> x);
    void refresh_candidates(std::span<const Vec3> x, std::span<const Vec3> v, double dt);
    template <class Pair>
    void choose(Watch<Pair>& watched) const;
    template <class Pair>
    auto working_out(std::span<const Vec3> x, std::span<const Vec3> v, double dt,
                     std::span<const Pushing<Pair>> pushing, Push* pushes) const;
    template <class Pair>
    Push push_of(const Pushing<Pair>& pushing, const ClosestPoints& points, std::span<const Vec3> v, double dt) const;

    SurfaceParts parts_;
    std::vector<double> masses_;
    double dhat_;
    double spacing_;
    double stiffness_;

    // But for the gaps nothing below changes what the next evaluation gives.
    Candidates candidates_;
    Watch<VertexTriangle> vertices_;
    Watch<EdgeEdge> edge_pairs_;
    std::vector<Push> pushes_;
    std::vector<Vec3> listed_at_; ///< positions the candidates were found at
    std::vector<double> reach_;   ///< how far each vertex may be from there before they are found anew [mm]
    std::vector<Vec3> last_x_;
    std::vector<double> step_;          ///< how far each vertex has moved since the last evaluation [mm]
    std::vector<double> vertex_path_;   ///< sums of these [mm]
    std::vector<double> triangle_path_; ///< sums of the largest of the three corners [mm]
    std::vector<double> edge_path_;     ///< of both ends [mm]
    std::vector<double> travel_limit_;
};

} // namespace corticle

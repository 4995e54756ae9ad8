// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/contact/near_pairs.hpp"

namespace corticle::contact
{

/// A step of a body's motion that has not been made yet.
struct Travel
{
    std::span<const Vec3> velocity; ///< of the body's nodes
    double dt;
    double longest; ///< no node moves farther [mm]
};

/// Keeps a surface from crossing itself in a step, whatever the forces are.
///
/// Two parts (a vertex and a triangle, or two edges) are held apart along the direction e between their closest points
/// at the start of the step. Their separation along it is
///
///     s = min over the first part of e · x_i  -  max over the second part of e · x_j
///
/// and at the end of the step it must be at least s_0 - 0.8 max(s_0 - l, 0), where l is the least separation of the
/// pair. On straight paths s is a concave function of time, so it is positive all along, and the parts do not meet. A
/// motion that both parts share leaves s as it is, and is never shortened.
///
/// The vertices of a pair that would come closer than that move on together, with the velocity of their common
/// momentum, and so do those of pairs that have a vertex in common. Nothing within such a group comes closer; groups
/// that would come too close to others are joined, until none does: at the latest where the surface is one group.
/// Pairs that are not near at the start stay apart since no vertex departs from the mean motion of the surface, or from
/// where it is, by more than 0.4 of the range of near pairs.
class TravelLimit
{
  public:
    /// @param masses        of the vertices
    /// @param vertex_least  least separation of each vertex from triangles [mm]
    /// @param edge_least    of each edge from others; a pair of edges has the larger of its two [mm]
    /// @param wall          see SurfaceParts; the mean motion is that of all other vertices
    TravelLimit(std::vector<double> masses, std::vector<double> vertex_least, std::vector<double> edge_least,
                std::int32_t wall = no_wall);

    /// Whether no pair comes too close, of those that a share of the vertices has to do with.
    /// @param places          of the vertices in the body
    /// @param least_distance  of all near pairs [mm]
    bool stays_apart(const NearPairs& near, double least_distance, const Travel& travel,
                     std::span<const std::int32_t> places);

    /// Changes displacements of vertices [mm] from the positions of `near`.
    /// @return the vertices whose displacement has changed, in ascending order. Collective.
    std::span<const std::int32_t> apply(const NearPairs& near, std::span<Vec3> displacements);

  private:
    using FourVertices = std::array<std::int32_t, 4>;
    struct Moving
    {
        double mass = 0.0;
        Vec3 moment; ///< sum of mass times displacement
    };

    double least_of(const VertexTriangle& pair) const;
    double least_of(const EdgeEdge& pair) const;
    void stay_with_the_mean(std::span<Vec3> displacements, double farthest);
    template <class Pair, class DisplacementOf>
    void find_closing(const NearPairs& near, const std::vector<Pair>& pairs, const DisplacementOf& displacement_of,
                      std::vector<FourVertices>& found) const;
    template <class DisplacementOf>
    bool find_closing(const NearPairs& near, const DisplacementOf& displacement_of);
    template <class Pair, class DisplacementOf>
    bool may_close(const FourVertices& vertex, const Pair& pair, const DisplacementOf& displacement_of) const;
    bool in_one_group(const FourVertices& vertex) const;
    void join_closing(const SurfaceShare& share, std::span<const Vec3> displacements);
    void move_together(std::span<Vec3> displacements);
    std::int32_t group_of(std::int32_t vertex) const;
    void join(std::int32_t a, std::int32_t b);

    std::vector<double> masses_;
    std::vector<double> vertex_least_;
    std::vector<double> edge_least_;
    double largest_least_; ///< of both [mm]
    std::size_t wall_;     ///< first vertex of the wall

    Vec3 mean_;                                      ///< displacement; zero where it need not be known [mm]
    double longest_way_ = 0.0;                       ///< of a vertex beside the mean [mm]
    std::vector<std::vector<FourVertices>> closing_; ///< pairs that would come too close, of blocks
    std::vector<std::int32_t> parent_;               ///< of each vertex, towards the first of its group
    std::vector<std::int32_t> grouped_;              ///< vertices in groups
    std::vector<Vec3> wanted_;                       ///< displacements before vertices were joined [mm]
    std::vector<Moving> of_group_;                   ///< at the first vertex of each group
    std::vector<std::int32_t> changed_;
};

} // namespace corticle::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/contact/candidates.hpp"

namespace corticle::contact
{

/// Vertices of a surface lie scattered in the body: so many of them ahead memory is asked for the next one.
inline constexpr std::int64_t places_ahead = 16;

/// The pairs of parts of a moving surface that are near: closer than a range now. Which they are and in which order
/// depends on the positions alone; what is remembered of earlier ones only saves work.
class NearPairs
{
  public:
    /// Blocks of pairs; their order is that of the pairs in all of them.
    template <class Pair>
    using Blocks = std::vector<std::vector<Pair>>;

    /// @param rest     reference positions of the surface vertices [mm]
    /// @param range    [mm]   @param spacing  particle spacing [mm]
    /// @param wall     see SurfaceParts   @param share  of the vertices, see SurfaceParts::find_candidates
    NearPairs(std::span<const Triangle> triangles, std::span<const Vec3> rest, double range, double spacing,
              std::int32_t wall = no_wall, SurfaceShare share = {});

    /// Finds the near pairs at positions x of a body, in which the vertices have these places. Collective.
    void update(std::span<const Vec3> x, std::span<const std::int32_t> places);

    const SurfaceParts& parts() const { return parts_; }
    const SurfaceShare& share() const { return share_; }
    double range() const { return range_; }
    /// Of the vertices, at the last update; of those that are not followed, at an earlier one [mm].
    std::span<const Vec3> positions() const { return x_; }
    /// Numbers of the vertices that are followed: all, or of a share those of the near pairs, and its own.
    std::span<const std::int32_t> followed_vertices() const { return followed_vertices_; }
    /// With their distance at these positions.
    const Blocks<VertexTriangle>& vertex_triangle() const { return vertices_.near; }
    const Blocks<EdgeEdge>& edge_edge() const { return edges_.near; }

  private:
    /// A candidate. The path of a pair is the length of way its two parts have moved: a pair measured once need not be
    /// measured again before that has grown by what it was too far.
    struct Watched
    {
        std::int32_t first;
        std::int32_t second;
        float due; ///< path at which it may be near, or a little less [mm]
    };
    /// The candidates, and those of them that are near.
    template <class Pair>
    struct Watch
    {
        std::vector<Watched> candidates;
        Blocks<Pair> near; ///< of blocks of the candidates, in their order
    };
    double path_of(const VertexTriangle& pair) const;
    double path_of(const EdgeEdge& pair) const;
    template <class Pair>
    Watched watched(const Pair& pair) const;
    bool follow(std::span<const Vec3> x, std::span<const std::int32_t> places);
    void find_candidates();
    void choose_followed();
    template <class Pair>
    auto watching(std::span<const Pair> pairs, Watch<Pair>& watch) const;
    template <class Pair>
    auto measuring(Watch<Pair>& watch) const;
    void measure();

    SurfaceParts parts_;
    SurfaceShare share_;
    double range_;
    double spacing_;
    Candidates candidates_;
    Watch<VertexTriangle> vertices_;
    Watch<EdgeEdge> edges_;
    std::vector<std::int32_t> followed_vertices_; ///< ascending
    std::vector<std::int32_t> followed_triangles_;
    std::vector<std::int32_t> followed_edges_;
    std::vector<Vec3> x_;
    std::vector<Vec3> listed_at_;       ///< positions the candidates were found at
    std::vector<double> reach_;         ///< how far each vertex may be from there before they are found anew [mm]
    std::vector<double> step_;          ///< how far each vertex has moved since the last update [mm]
    std::vector<double> vertex_path_;   ///< sums of these since the candidates were found [mm]
    std::vector<double> triangle_path_; ///< sums of the largest of the three corners [mm]
    std::vector<double> edge_path_;     ///< of both ends [mm]
};

/// Calls act(pair) for the pairs of all blocks, in order.
template <class Pair, class Act>
void for_each_of(const NearPairs::Blocks<Pair>& blocks, Act&& act)
{
    for (const std::vector<Pair>& block : blocks)
    {
        for (const Pair& pair : block)
        {
            act(pair);
        }
    }
}

} // namespace corticle::contact

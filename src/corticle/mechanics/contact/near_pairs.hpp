// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/contact/candidates.hpp"

namespace corticle
{

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
    NearPairs(std::span<const Triangle> triangles, std::span<const Vec3> rest, double range, double spacing);

    /// Finds the near pairs at positions x.
    void update(std::span<const Vec3> x);

    const SurfaceParts& parts() const { return parts_; }
    double range() const { return range_; }
    /// Positions of the last update [mm].
    std::span<const Vec3> positions() const { return last_x_; }
    /// With their distance at these positions.
    const Blocks<VertexTriangle>& vertex_triangle() const { return vertices_.near; }
    const Blocks<EdgeEdge>& edge_edge() const { return edges_.near; }

  private:
    /// What is known of candidates, and those of them that are near. The path of a pair is the length of way its two
    /// parts have moved: a pair measured once need not be measured again before that has grown by what it was too far.
    template <class Pair>
    struct Watch
    {
        std::vector<double> due; ///< path at which each candidate may be near [mm]
        Blocks<Pair> near;       ///< of blocks of the candidates, in their order
    };
    template <class Pair>
    auto watching(std::span<const Pair> pairs, Watch<Pair>& watched) const;
    template <class Pair>
    auto measuring(std::span<const Vec3> x, std::span<const Pair> pairs, Watch<Pair>& watched) const;
    double path_of(const VertexTriangle& pair) const;
    double path_of(const EdgeEdge& pair) const;
    bool follow(std::span<const Vec3> x);
    void refresh_candidates(std::span<const Vec3> x);

    SurfaceParts parts_;
    double range_;
    double spacing_;
    Candidates candidates_;
    Watch<VertexTriangle> vertices_;
    Watch<EdgeEdge> edges_;
    std::vector<Vec3> listed_at_; ///< positions the candidates were found at
    std::vector<double> reach_;   ///< how far each vertex may be from there before they are found anew [mm]
    std::vector<Vec3> last_x_;
    std::vector<double> step_;          ///< how far each vertex has moved since the last update [mm]
    std::vector<double> vertex_path_;   ///< sums of these [mm]
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

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/delaunay_flips.hpp"

#include "corticle/mesh/sizes.hpp"

#include <cmath>
#include <numbers>
#include <unordered_map>

namespace corticle::geometry
{

namespace
{

/// The triangles of a closed surface with a map from each directed edge to the triangle on its left.
class FlipMesh
{
  public:
    FlipMesh(TriangleMesh& mesh, std::span<const char> stays) : mesh_(mesh), stays_(stays)
    {
        left_.reserve(3 * mesh.triangles.size());
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        {
            link(static_cast<std::int32_t>(f));
        }
    }

    /// Flips edge k (opposite to corner k) of triangle f if that is allowed and makes it Delaunay.
    bool flip_if_needed(std::int32_t f, int k)
    {
        const Triangle t = mesh_.triangles[f];
        const std::int32_t a = t[(k + 1) % 3];
        const std::int32_t b = t[(k + 2) % 3];
        const std::int32_t c = t[k];
        const auto twin = left_.find(key(b, a));
        if (twin == left_.end())
        {
            return false;
        }
        const std::int32_t g = twin->second;
        const std::int32_t d = opposite(mesh_.triangles[g], a, b);
        if (stays(a) || stays(b) || stays(c) || stays(d))
        {
            return false;
        }
        constexpr double slack = 1e-9; // so that four points on a circle do not flip for ever
        const bool delaunay = angle(c, a, b) + angle(d, a, b) <= std::numbers::pi + slack;
        if (delaunay || left_.contains(key(c, d)) || left_.contains(key(d, c)) || folds(a, b, c, d))
        {
            return false;
        }
        left_.erase(key(a, b));
        left_.erase(key(b, a));
        mesh_.triangles[f] = {a, d, c};
        mesh_.triangles[g] = {d, b, c};
        link(f);
        link(g);
        return true;
    }

  private:
    static std::uint64_t key(std::int32_t a, std::int32_t b)
    {
        return (static_cast<std::uint64_t>(a) << 32) | static_cast<std::uint64_t>(b);
    }

    static std::int32_t opposite(const Triangle& t, std::int32_t a, std::int32_t b)
    {
        return t[0] != a && t[0] != b ? t[0] : (t[1] != a && t[1] != b ? t[1] : t[2]);
    }

    void link(std::int32_t f)
    {
        const Triangle& t = mesh_.triangles[f];
        for (int k = 0; k < 3; ++k)
        {
            left_[key(t[k], t[(k + 1) % 3])] = f;
        }
    }

    double angle(std::int32_t at, std::int32_t a, std::int32_t b) const
    {
        const Vec3 e1 = mesh_.vertices[a] - mesh_.vertices[at];
        const Vec3 e2 = mesh_.vertices[b] - mesh_.vertices[at];
        return std::atan2(norm(cross(e1, e2)), dot(e1, e2));
    }

    Vec3 normal(std::int32_t a, std::int32_t b, std::int32_t c) const
    {
        return cross(mesh_.vertices[b] - mesh_.vertices[a], mesh_.vertices[c] - mesh_.vertices[a]);
    }

    /// Is the edge a crease, or would one of the new triangles look the other way?
    bool folds(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) const
    {
        const Vec3 n_c = normal(a, b, c);
        const Vec3 n_d = normal(b, a, d);
        constexpr double crease = 0.7; // cosine of the angle between the normals
        const Vec3 old_normal = n_c + n_d;
        return dot(n_c, n_d) < crease * norm(n_c) * norm(n_d) || dot(normal(a, d, c), old_normal) <= 0.0 ||
               dot(normal(d, b, c), old_normal) <= 0.0;
    }

    bool stays(std::int32_t vertex) const { return !stays_.empty() && stays_[vertex] != 0; }

    TriangleMesh& mesh_;
    std::span<const char> stays_;
    std::unordered_map<std::uint64_t, std::int32_t> left_;
};

} // namespace

void flip_to_delaunay(TriangleMesh& mesh, std::span<const char> stays)
{
    require_vertices(mesh);
    if (!stays.empty())
    {
        require_size("marks of the vertices that stay", stays.size(), mesh.vertices.size());
    }
    FlipMesh flips(mesh, stays);
    constexpr int most_sweeps = 100; // a few are enough; Lawson's flips end, but not provably so off the plane
    bool flipped = true;
    for (int sweep = 0; sweep < most_sweeps && flipped; ++sweep)
    {
        flipped = false;
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        {
            for (int k = 0; k < 3; ++k)
            {
                flipped = flips.flip_if_needed(static_cast<std::int32_t>(f), k) || flipped;
            }
        }
    }
}

} // namespace corticle::geometry

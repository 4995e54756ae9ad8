// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/random.hpp"
#include "corticle/cloud/neighbors.hpp"
#include "corticle/cloud/ordered_cloud.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/material/tissue.hpp"
#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace corticle::bench
{

/// A ball with particles on its surface and on a jittered lattice below it, spacing 1, in the order of a space-filling
/// curve: made in seconds at a million, and to the pair passes the same as a prepared body.
inline Cloud jittered_ball(std::int64_t count)
{
    constexpr double jitter = 0.2;
    constexpr std::uint64_t seed = 1;
    const double radius = std::cbrt(3.0 * static_cast<double>(count) / (4.0 * std::numbers::pi));
    const auto reach = static_cast<int>(radius) + 1;
    const TriangleMesh surface = geometry::make_ellipsoid({radius, radius, radius}, 1.0);
    std::vector<Vec3> points = surface.vertices;
    std::uint64_t counter = 0;
    const auto offset = [&] { return jitter * (2.0 * hash_uniform(seed, counter++) - 1.0); };
    for (int z = -reach; z <= reach; ++z)
    {
        for (int y = -reach; y <= reach; ++y)
        {
            for (int x = -reach; x <= reach; ++x)
            {
                const Vec3 at{x + offset(), y + offset(), z + offset()};
                if (norm(at) <= radius - 0.75)
                {
                    points.push_back(at);
                }
            }
        }
    }
    Cloud cloud = cloud::ordered_cloud(points, {std::vector<double>(points.size(), 1.0), points}, surface);
    cloud.spacing = 1.0;
    return cloud;
}

/// Support at which the particles of the ball have this many neighbours in the mean, counted on a sample of them.
inline double support_for(double neighbors, const Cloud& cloud)
{
    constexpr double longest = 3.2;
    const CellGrid grid(cloud.positions, longest);
    const std::size_t stride = std::max<std::size_t>(1, cloud.positions.size() / 4000);
    std::vector<double> squares;
    std::size_t sample = 0;
    for (std::size_t i = 0; i < cloud.positions.size(); i += stride)
    {
        grid.near(cloud.positions[i],
                  [&](std::int32_t j, const Vec3& X)
                  {
                      if (static_cast<std::size_t>(j) != i)
                      {
                          squares.push_back(squared_norm(X - cloud.positions[i]));
                      }
                  });
        ++sample;
    }
    const auto place = squares.begin() + static_cast<std::ptrdiff_t>(neighbors * static_cast<double>(sample));
    std::nth_element(squares.begin(), place, squares.end());
    return std::sqrt(*place);
}

inline constexpr double usual_neighbors = 57.0;

/// The ball as a body with a smooth cortex of three spacings.
struct Ball
{
    explicit Ball(std::int64_t count) : Ball(jittered_ball(count)) {}

    tlsph::Particles particles;
    material::TissueOptions options;
    material::TissueFields fields;
    material::TissueState state;

    material::Tissue tissue() const { return {options, fields, state}; }
    double pairs = 0.0;

  private:
    explicit Ball(const Cloud& cloud)
    {
        tlsph::TlsphOptions tlsph;
        tlsph.support = support_for(usual_neighbors, cloud);
        const Neighbors neighbors = cloud::find_pairs_within(cloud.positions, tlsph.support * cloud.spacing);
        pairs = static_cast<double>(neighbors.index.size());
        particles = tlsph::make_particles(cloud, neighbors, tlsph);
        const double radius = std::cbrt(3.0 * static_cast<double>(cloud.positions.size()) / (4.0 * std::numbers::pi));
        options.thickness_mm = 3.0;
        fields.volume = cloud.volumes;
        fields.regional_rate.assign(cloud.positions.size(), 1.0);
        for (const Vec3& X : cloud.positions)
        {
            fields.depth.push_back(std::max(0.0, radius - norm(X)));
            fields.normal.push_back(normalized(X));
        }
        material::set_layer(fields, options, {}, 0.0, state);
    }
};

} // namespace corticle::bench

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/enclosing_surface.hpp"

#include "corticle/base/parallel.hpp"

#include <numeric>

namespace corticle::boundary
{

EnclosingSurface::EnclosingSurface(std::span<const Triangle> triangles, std::size_t vertices)
    : triangles_(triangles.begin(), triangles.end()), begin_(vertices + 1), opposite_(3 * triangles.size()),
      gradient_(vertices)
{
    for (const Triangle& corner : triangles_)
    {
        for (const std::int32_t vertex : corner)
        {
            ++begin_[static_cast<std::size_t>(vertex) + 1];
        }
    }
    std::partial_sum(begin_.begin(), begin_.end(), begin_.begin());
    std::vector<std::int32_t> next(begin_.begin(), begin_.end() - 1);
    for (const Triangle& corner : triangles_)
    {
        for (std::size_t k = 0; k < 3; ++k)
        {
            opposite_[static_cast<std::size_t>(next[static_cast<std::size_t>(corner[k])]++)] = {corner[(k + 1) % 3],
                                                                                                corner[(k + 2) % 3]};
        }
    }
}

void EnclosingSurface::evaluate(std::span<const Vec3> x)
{
    if (gradient_.empty())
    {
        return;
    }
    const Vec3 origin = x[0];
    parallel_for(std::ssize(gradient_),
                 [&](std::int64_t a)
                 {
                     Vec3 sum;
                     for (std::int32_t k = begin_[a]; k < begin_[a + 1]; ++k)
                     {
                         const auto& [b, c] = opposite_[k];
                         sum += cross(x[b] - origin, x[c] - origin);
                     }
                     gradient_[a] = sum / 6.0;
                 });
    // V is homogeneous of degree three in the positions about the origin.
    volume_ =
        parallel_sum(std::ssize(gradient_), [&](std::int64_t a) { return dot(gradient_[a], x[a] - origin) / 3.0; });
}

} // namespace corticle::boundary

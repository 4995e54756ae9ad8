// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/sizes.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

namespace corticle
{

void require_size(std::string_view what, std::size_t got, std::size_t expected)
{
    if (got != expected)
    {
        throw InputError(fmt::format("{}: got {} values, expected {}", what, got, expected));
    }
}

void require_triangles(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    if (triangles.empty())
    {
        throw InputError("a surface without triangles: got 0, expected at least one");
    }
    for (std::size_t k = 0; k < triangles.size(); ++k)
    {
        for (const std::int32_t vertex : triangles[k])
        {
            if (vertex < 0 || static_cast<std::size_t>(vertex) >= vertices.size())
            {
                throw InputError(fmt::format("triangle {}: got vertex {}, expected 0 to {}", k, vertex,
                                             static_cast<std::ptrdiff_t>(vertices.size()) - 1));
            }
        }
    }
}

} // namespace corticle

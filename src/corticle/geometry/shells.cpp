// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/shells.hpp"

#include "corticle/geometry/surface_faults.hpp"
#include "corticle/geometry/surface_tree.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace corticle::geometry
{

namespace
{

constexpr double small_share = 0.01;

double volume_of(const TriangleMesh& shell)
{
    return enclosed_volume(shell.vertices, shell.triangles);
}

} // namespace

std::vector<TriangleMesh> separate_shells(const TriangleMesh& surface)
{
    const std::vector<std::int32_t> shell = shells_of(surface);
    std::vector<TriangleMesh> shells(shell.empty() ? 0
                                                   : static_cast<std::size_t>(*std::ranges::max_element(shell) + 1));
    std::vector<std::int32_t> number(surface.vertices.size(), -1);
    for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    {
        TriangleMesh& mesh = shells[static_cast<std::size_t>(shell[t])];
        Triangle corners = surface.triangles[t];
        for (std::int32_t& vertex : corners)
        {
            if (number[vertex] < 0)
            {
                number[vertex] = static_cast<std::int32_t>(mesh.vertices.size());
                mesh.vertices.push_back(surface.vertices[vertex]);
            }
            vertex = number[vertex];
        }
        mesh.triangles.push_back(corners);
    }
    return shells;
}

TriangleMesh drop_open_crumbs(const TriangleMesh& surface, std::vector<std::string>& lines)
{
    const std::vector<std::int32_t> shell = shells_of(surface);
    const std::vector<TriangleMesh> shells = separate_shells(surface);
    std::vector<char> is_crumb(shells.size(), 0);
    const double least = small_share * surface_area(surface.vertices, surface.triangles);
    std::int64_t dropped = 0;
    for (std::size_t s = 0; s < shells.size(); ++s)
    {
        const bool is_small = surface_area(shells[s].vertices, shells[s].triangles) < least;
        is_crumb[s] = is_small && find_edge_faults(shells[s]).boundary_edges > 0 ? 1 : 0;
        dropped += is_crumb[s];
    }
    if (dropped == 0)
    {
        return surface;
    }
    lines.push_back(fmt::format("dropped {} open pieces of less than {:g} % of the area", dropped, 100 * small_share));
    std::vector<char> keep;
    keep.reserve(shell.size());
    for (const std::int32_t s : shell)
    {
        keep.push_back(is_crumb[static_cast<std::size_t>(s)] != 0 ? 0 : 1);
    }
    return kept_triangles(surface, keep);
}

TriangleMesh outer_shell(const TriangleMesh& surface, const std::string& file, std::vector<double>& volumes,
                         std::vector<std::string>& lines)
{
    std::vector<TriangleMesh> shells = separate_shells(surface);
    if (shells.empty())
    {
        throw InputError(fmt::format("{}: nothing is left of the surface; expected a body", file));
    }
    std::ranges::stable_sort(shells, std::greater<>{}, [](const TriangleMesh& s) { return std::abs(volume_of(s)); });
    TriangleMesh& body = shells.front();
    if (volume_of(body) < 0.0)
    {
        for (Triangle& t : body.triangles)
        {
            std::swap(t[1], t[2]);
        }
        lines.emplace_back("turned the surface outward: it was inside-out");
    }
    volumes.clear();
    for (const TriangleMesh& shell : shells)
    {
        volumes.push_back(std::abs(volume_of(shell)));
    }
    const SurfaceTree tree(body.vertices, body.triangles);
    std::int64_t loose = 0;
    for (std::size_t s = 1; s < shells.size(); ++s)
    {
        const auto is_inside = [&](const Vec3& p) { return tree.winding_number(p) != 0; };
        if (std::ranges::all_of(shells[s].vertices, is_inside))
        {
            lines.push_back(fmt::format("dropped an inner shell of {:.4g} mm³", volumes[s]));
        }
        else if (volumes[s] < small_share * volumes[0])
        {
            ++loose;
        }
        else
        {
            throw SeveralShells(fmt::format("{}: several shells: one of {:.6g} mm³ beside or across the largest of "
                                            "{:.6g} mm³; expected one body, others inside it or below {:g} % of it",
                                            file, volumes[s], volumes[0], 100 * small_share));
        }
    }
    if (loose > 0)
    {
        lines.push_back(
            fmt::format("dropped {} loose shells of less than {:g} % of the volume", loose, 100 * small_share));
    }
    return std::move(body);
}

} // namespace corticle::geometry

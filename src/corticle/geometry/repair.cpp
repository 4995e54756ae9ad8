// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/repair.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/alpha_wrap.hpp"
#include "corticle/geometry/bodies.hpp"
#include "corticle/geometry/mend.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/geometry/shells.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/geometry/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <new>
#include <optional>

namespace corticle::geometry
{

namespace
{

/// Vertices closer than this share of the size are the same: what rounding to single precision leaves.
constexpr double same_place = 1e-6;
constexpr double alpha_per_diagonal = 1.0 / 60.0;
constexpr double largest_alpha = 0.25; // of the diagonal, where we choose
constexpr double offset_per_alpha = 1.0 / 20.0;
constexpr double largest_offset = 1.0 / 400.0;
/// Finer wraps than these shares of the size take minutes and millions of triangles.
constexpr double finest_alpha = 1e-3;
constexpr double finest_offset = 1e-5;

void require_finite(const TriangleMesh& surface, const std::string& file)
{
    for (std::size_t v = 0; v < surface.vertices.size(); ++v)
    {
        const Vec3& p = surface.vertices[v];
        if (!is_finite(p))
        {
            throw InputError(fmt::format("{}: vertex {} is not finite: ({}, {}, {})", file, v, p.x, p.y, p.z));
        }
    }
}

/// A message without "FILE: " before it.
std::string without_name(const std::string& message, const std::string& file)
{
    return message.starts_with(file + ": ") ? message.substr(file.size() + 2) : message;
}

/// All triangles hang together by their vertices.
bool is_connected(const TriangleMesh& surface)
{
    return std::ranges::all_of(shells_of(surface), [](std::int32_t shell) { return shell == 0; });
}

/// The fault that require_valid_surface names; nothing for a valid surface.
std::optional<std::string> fault_of(const TriangleMesh& surface, const std::string& file)
{
    try
    {
        require_valid_surface(surface, file);
    }
    catch (const InputError& error)
    {
        return without_name(error.what(), file);
    }
    return std::nullopt;
}

TriangleMesh without_flat_triangles(const TriangleMesh& surface)
{
    std::vector<char> keep;
    keep.reserve(surface.triangles.size());
    for (const Triangle& t : surface.triangles)
    {
        const Vec3& a = surface.vertices[t[0]];
        keep.push_back(squared_norm(cross(surface.vertices[t[1]] - a, surface.vertices[t[2]] - a)) > 0.0 ? 1 : 0);
    }
    return kept_triangles(surface, keep);
}

/// The triangles with what is double or without extent dropped.
TriangleMesh cleaned(const TriangleMesh& surface, const std::string& file, RepairReport& report)
{
    TriangleMesh clean = merge_duplicates(surface);
    if (clean.triangles.empty())
    {
        throw InputError(fmt::format("{}: no triangle with an extent; expected a surface", file));
    }
    if (find_edge_faults(clean).boundary_edges > 0)
    {
        clean = merge_within(clean, same_place * bounding_diagonal(clean));
    }
    clean = drop_repeated_triangles(clean);
    report.duplicate_vertices = std::ssize(surface.vertices) - std::ssize(clean.vertices);
    report.dropped_triangles = std::ssize(surface.triangles) - std::ssize(clean.triangles);
    report.edges = find_edge_faults(clean);
    report.area_before_mm2 = surface_area(clean.vertices, clean.triangles);
    report.volume_before_mm3 = enclosed_volume(clean.vertices, clean.triangles);
    report.inside_out = report.volume_before_mm3 < 0.0;
    return clean;
}

void describe_faults(RepairReport& report)
{
    const EdgeFaults& edges = report.edges;
    std::vector<std::string>& lines = report.lines;
    if (report.duplicate_vertices > 0 || report.dropped_triangles > 0)
    {
        lines.push_back(fmt::format("merged or dropped {} vertices and {} triangles that were double or without extent",
                                    report.duplicate_vertices, report.dropped_triangles));
    }
    if (!edges.holes.empty())
    {
        lines.push_back(
            fmt::format("found {} holes with {} boundary edges, the largest of {} edges and {:.4g} mm around",
                        edges.holes.size(), edges.boundary_edges, edges.holes[0].edges, edges.holes[0].length_mm));
    }
    if (edges.crowded_edges > 0)
    {
        lines.push_back(fmt::format("found {} edges with more than two triangles", edges.crowded_edges));
    }
    if (edges.opposed_edges > 0)
    {
        lines.push_back(
            fmt::format("oriented the triangles: {} edges lay between two of opposite sense", edges.opposed_edges));
    }
}

/// @throws InputError, one line without the name of the file, where something could not be mended
TriangleMesh mended(const TriangleMesh& clean, const std::string& file, RepairReport& report)
{
    std::int64_t filled = 0;
    TriangleMesh mesh = drop_open_crumbs(open_pinched_holes(clean), report.lines);
    mesh = orient_and_fill_holes(mesh, filled);
    if (filled > 0)
    {
        report.lines.push_back(fmt::format("filled {} holes", filled));
    }
    mesh = outer_shell(mesh, file, report.shell_volumes_mm3, report.lines);
    report.crossing_pairs = std::ssize(self_intersections(mesh));
    if (report.crossing_pairs > 0)
    {
        if (!remove_self_intersections(mesh))
        {
            throw InputError(
                fmt::format("{} pairs of triangles that cross could not be mended", report.crossing_pairs));
        }
        report.lines.push_back(
            fmt::format("replaced the surface about {} pairs of triangles that crossed", report.crossing_pairs));
    }
    return mesh;
}

/// Wide enough for the ball not to fall through the widest hole, as far as the size allows.
double chosen_alpha(const RepairReport& report, double diagonal)
{
    constexpr double margin = 1.2;
    double widest = 0.0;
    for (const SurfaceHole& hole : report.edges.holes)
    {
        widest = std::max(widest, hole.radius_mm);
    }
    return std::clamp(margin * widest, alpha_per_diagonal * diagonal, largest_alpha * diagonal);
}

/// A wrap would join bodies that lie apart, or drop some of them.
SurfaceBodies require_one_body(const TriangleMesh& clean, const std::string& file)
{
    SurfaceBodies found = find_bodies(clean);
    if (found.separate > 1)
    {
        throw InputError(fmt::format("{}: several shells: {} bodies that lie apart, {:.4g} mm at the closest, about "
                                     "({:.4g}, {:.4g}, {:.4g}) mm; a wrap would join or drop them; expected one body",
                                     file, found.separate, found.gap->width_mm, found.gap->place.x, found.gap->place.y,
                                     found.gap->place.z));
    }
    return found;
}

/// What the wrap made of the body: handles, and parts that it spans.
void describe_wrap(const SurfaceBodies& before, const TriangleMesh& wrap, double alpha, RepairReport& report)
{
    report.bodies_before = before.separate;
    report.genus_after = genus_of(wrap);
    if (before.bodies.empty())
    {
        report.lines.emplace_back("wrapped what encloses no body by itself into 1 body");
        return;
    }
    const TriangleMesh& body = before.bodies.front();
    report.genus_before = genus_of(body);
    const SurfaceTree tree(wrap.vertices, wrap.triangles);
    Vec3 place;
    for (const Vec3& vertex : body.vertices)
    {
        const double distance = std::sqrt(tree.closest(vertex).squared_distance);
        place = distance > report.left_out_mm ? vertex : place;
        report.left_out_mm = std::max(report.left_out_mm, distance);
    }
    report.lines.push_back(fmt::format("wrapped {} bodies, {} that lie apart, into 1 body: genus {} became {}, points "
                                       "lie up to {:.4g} mm from the wrap, at ({:.4g}, {:.4g}, {:.4g}) mm",
                                       before.bodies.size(), before.separate, report.genus_before, report.genus_after,
                                       report.left_out_mm, place.x, place.y, place.z));
    if (report.genus_after > report.genus_before)
    {
        report.warnings.push_back(fmt::format("the wrap has genus {}, the surface {}: it bridges gaps narrower than "
                                              "{:.4g} mm",
                                              report.genus_after, report.genus_before, 2.0 * alpha));
    }
    if (report.left_out_mm > alpha)
    {
        report.warnings.push_back(fmt::format("the wrap leaves out parts of the surface up to {:.4g} mm away, at "
                                              "({:.4g}, {:.4g}, {:.4g}) mm: it spans gaps narrower than {:.4g} mm",
                                              report.left_out_mm, place.x, place.y, place.z, 2.0 * alpha));
    }
}

TriangleMesh wrapped(const TriangleMesh& clean, const std::string& file, const RepairOptions& options,
                     RepairReport& report)
{
    const double diagonal = bounding_diagonal(clean);
    const double alpha = options.alpha_mm > 0.0 ? options.alpha_mm : chosen_alpha(report, diagonal);
    const double offset =
        options.offset_mm > 0.0 ? options.offset_mm : std::min(offset_per_alpha * alpha, largest_offset * diagonal);
    const SurfaceBodies before = require_one_body(clean, file);
    report.wrapped = true;
    report.lines.push_back(fmt::format("wrapped with alpha {:.4g} mm and offset {:.4g} mm", alpha, offset));
    TriangleMesh mesh = fitted_alpha_wrap(without_flat_triangles(clean), alpha, offset);
    mesh = outer_shell(mesh, file, report.shell_volumes_mm3, report.lines);
    const double volume = enclosed_volume(mesh.vertices, mesh.triangles);
    const double area = surface_area(mesh.vertices, mesh.triangles);
    if (volume < 3.0 * offset * area) // both sides of a sheet, an offset away from it
    {
        throw InputError(fmt::format("{}: the wrap went inside through a hole (volume {:.4g} mm³, area {:.4g} mm²); "
                                     "expected alpha_mm above {:.4g}",
                                     file, volume, area, alpha));
    }
    describe_wrap(before, mesh, alpha, report);
    return mesh;
}

void require_usable_lengths(const RepairOptions& options, double diagonal)
{
    const auto require = [](const char* name, double length, double least)
    {
        const bool is_chosen_here = length == 0.0;
        if (!is_chosen_here && !(length >= least && std::isfinite(length)))
        {
            throw InputError(fmt::format("{} of the wrap: got {} mm; expected 0 (chosen by the surface) or at least "
                                         "{:.3g} mm for a surface of this size",
                                         name, length, least));
        }
    };
    require("alpha_mm", options.alpha_mm, finest_alpha * diagonal);
    require("offset_mm", options.offset_mm, finest_offset * diagonal);
}

RepairedSurface finished(TriangleMesh mesh, RepairReport report)
{
    report.area_after_mm2 = surface_area(mesh.vertices, mesh.triangles);
    report.volume_after_mm3 = enclosed_volume(mesh.vertices, mesh.triangles);
    return {std::move(mesh), std::move(report)};
}

} // namespace

RepairedSurface repair_surface(const TriangleMesh& surface, const std::string& file, Repair choice,
                               const RepairOptions& options)
{
    require_finite(surface, file);
    RepairReport report;
    TriangleMesh clean = merge_duplicates(surface);
    if (choice == Repair::none)
    {
        require_valid_surface(clean, file);
    }
    if (choice != Repair::wrap && !fault_of(clean, file))
    {
        report.area_before_mm2 = surface_area(clean.vertices, clean.triangles);
        report.volume_before_mm3 = enclosed_volume(clean.vertices, clean.triangles);
        report.duplicate_vertices = std::ssize(surface.vertices) - std::ssize(clean.vertices);
        report.dropped_triangles = std::ssize(surface.triangles) - std::ssize(clean.triangles);
        report.shell_volumes_mm3 = {report.volume_before_mm3};
        return finished(std::move(clean), std::move(report));
    }
    clean = cleaned(surface, file, report);
    require_usable_lengths(options, bounding_diagonal(clean));
    describe_faults(report);
    if (choice == Repair::automatic)
    {
        std::optional<std::string> fault;
        try
        {
            TriangleMesh mesh = mended(clean, file, report);
            fault = fault_of(mesh, file);
            if (!fault)
            {
                return finished(std::move(mesh), std::move(report));
            }
        }
        catch (const SeveralShells& error)
        {
            if (!is_connected(clean))
            {
                throw;
            }
            fault = without_name(error.what(), file); // one body with walls inside, cut apart
        }
        catch (const std::bad_alloc&)
        {
            throw; // no fault of the surface
        }
        catch (const std::exception& error) // of ours, or one that CGAL throws where it is at a loss
        {
            fault = without_name(error.what(), file);
        }
        report.lines.push_back(fmt::format("mending was not enough: {}", *fault));
    }
    TriangleMesh mesh = wrapped(clean, file, options, report);
    if (const auto fault = fault_of(mesh, file))
    {
        throw InputError(fmt::format("{}: cannot be repaired: {} after a wrap; expected a surface that a wrap of "
                                     "another alpha_mm closes",
                                     file, *fault));
    }
    return finished(std::move(mesh), std::move(report));
}

} // namespace corticle::geometry

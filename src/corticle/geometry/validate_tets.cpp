// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/validate_tets.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/validate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

namespace corticle::geometry
{

namespace
{

constexpr double flat_mean_ratio = 1e-6;    ///< a volume of about 1e-9 cubic edges: little above round-off
constexpr double sliver_mean_ratio = 0.05;  ///< a height of about a hundredth of the edges
constexpr double most_slivers = 0.5;        ///< of the tets
constexpr std::size_t most_parts_named = 5; ///< in a message

/// Counts and lines of one repair after the other.
class Repair
{
  public:
    Repair(TetMesh mesh, const std::string& file) : mesh_(std::move(mesh)), file_(file) {}

    void require_numbers() const;
    void merge_nodes();
    void drop_repeated_tets();
    void drop_flat_tets();
    void flip_left_handed();
    void drop_unused_nodes();
    void require_one_body() const;
    void require_shape();

    TetMesh take_mesh() { return std::move(mesh_); }
    const TetReport& report() const { return report_; }

  private:
    [[noreturn]] void refuse(const std::string& what) const { throw InputError(fmt::format("{}: {}", file_, what)); }
    void say(std::int64_t count, const std::string& line)
    {
        if (count > 0)
        {
            report_.lines.push_back(line);
        }
    }
    void require_tets_left(const char* reason) const
    {
        if (mesh_.tets.empty())
        {
            refuse(reason);
        }
    }
    std::string flats_dropped() const
    {
        return report_.flat_tets > 0 ? fmt::format(" (once {} flat tets are dropped)", report_.flat_tets) : "";
    }

    TetMesh mesh_;
    std::string file_;
    TetReport report_;
};

void Repair::require_numbers() const
{
    require_tets_left("no tets in the mesh; expected at least one");
    for (std::size_t v = 0; v < mesh_.vertices.size(); ++v)
    {
        const Vec3& p = mesh_.vertices[v];
        if (!is_finite(p))
        {
            refuse(fmt::format("node {} is not finite: ({}, {}, {})", v, p.x, p.y, p.z));
        }
    }
    const std::int64_t count = std::ssize(mesh_.vertices);
    for (std::size_t i = 0; i < mesh_.tets.size(); ++i)
    {
        for (const std::int32_t node : mesh_.tets[i])
        {
            if (node < 0 || node >= count)
            {
                refuse(fmt::format("tet {} refers to node {}; expected 0 to {}", i, node, count - 1));
            }
        }
    }
}

void Repair::merge_nodes()
{
    const std::vector<Vec3>& p = mesh_.vertices;
    std::vector<std::int32_t> order(p.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(),
              [&](std::int32_t a, std::int32_t b)
              { return std::tie(p[a].x, p[a].y, p[a].z, a) < std::tie(p[b].x, p[b].y, p[b].z, b); });
    std::vector<std::int32_t> same(p.size());
    for (std::size_t k = 0; k < order.size(); ++k)
    {
        const bool repeats = k > 0 && p[order[k]] == p[order[k - 1]];
        same[order[k]] = repeats ? same[order[k - 1]] : order[k];
    }
    std::vector<char> repeated(p.size(), 0);
    for (Tet& tet : mesh_.tets)
    {
        for (std::int32_t& node : tet)
        {
            repeated[node] |= static_cast<char>(same[node] != node);
            node = same[node];
        }
    }
    report_.merged_nodes = std::count(repeated.begin(), repeated.end(), 1);
    say(report_.merged_nodes, fmt::format("{} nodes lie exactly on another one: merged", report_.merged_nodes));
}

void Repair::drop_repeated_tets()
{
    const auto ascending = [&](std::int32_t i)
    {
        Tet tet = mesh_.tets[i];
        std::sort(tet.begin(), tet.end());
        return tet;
    };
    std::vector<std::pair<Tet, std::int32_t>> order(mesh_.tets.size());
    for (std::size_t i = 0; i < order.size(); ++i)
    {
        order[i] = {ascending(static_cast<std::int32_t>(i)), static_cast<std::int32_t>(i)};
    }
    std::sort(order.begin(), order.end());
    std::vector<char> keep(mesh_.tets.size(), 1);
    for (std::size_t k = 1; k < order.size(); ++k)
    {
        keep[order[k].second] = order[k].first != order[k - 1].first;
    }
    std::size_t next = 0;
    std::erase_if(mesh_.tets, [&](const Tet&) { return keep[next++] == 0; });
    report_.repeated_tets = std::ssize(keep) - std::ssize(mesh_.tets);
    say(report_.repeated_tets,
        fmt::format("{} tets have the same nodes as another one: dropped", report_.repeated_tets));
}

void Repair::drop_flat_tets()
{
    const std::int64_t before = std::ssize(mesh_.tets);
    std::erase_if(mesh_.tets, [&](const Tet& tet) { return !(mean_ratio(mesh_.vertices, tet) > flat_mean_ratio); });
    report_.flat_tets = before - std::ssize(mesh_.tets);
    require_tets_left("flat: no tet has a volume; expected a solid body");
    say(report_.flat_tets, fmt::format("{} tets are flat: dropped", report_.flat_tets));
}

void Repair::flip_left_handed()
{
    for (Tet& tet : mesh_.tets)
    {
        if (signed_volume(mesh_.vertices, tet) < 0.0)
        {
            std::swap(tet[2], tet[3]);
            ++report_.flipped_tets;
        }
    }
    report_.is_left_handed = report_.flipped_tets == std::ssize(mesh_.tets);
    say(report_.flipped_tets,
        report_.is_left_handed
            ? fmt::format("all {} tets are left-handed: flipped", report_.flipped_tets)
            : fmt::format("{} of {} tets are left-handed: flipped", report_.flipped_tets, mesh_.tets.size()));
}

void Repair::drop_unused_nodes()
{
    std::vector<std::int32_t> number(mesh_.vertices.size(), -1);
    for (const Tet& tet : mesh_.tets)
    {
        for (const std::int32_t node : tet)
        {
            number[node] = 0;
        }
    }
    std::vector<Vec3> kept;
    for (std::size_t v = 0; v < number.size(); ++v)
    {
        if (number[v] == 0)
        {
            number[v] = static_cast<std::int32_t>(kept.size());
            kept.push_back(mesh_.vertices[v]);
        }
    }
    for (Tet& tet : mesh_.tets)
    {
        tet = {number[tet[0]], number[tet[1]], number[tet[2]], number[tet[3]]};
    }
    report_.dropped_nodes = std::ssize(mesh_.vertices) - std::ssize(kept) - report_.merged_nodes;
    mesh_.vertices = std::move(kept);
    say(report_.dropped_nodes, fmt::format("{} nodes belong to no tet: dropped", report_.dropped_nodes));
}

/// Tets of each part that hangs together by faces, largest part first.
std::vector<std::int64_t> part_sizes(const TetNeighbors& neighbors)
{
    std::vector<std::int64_t> sizes;
    std::vector<char> seen(neighbors.size(), 0);
    std::vector<std::int32_t> to_visit;
    for (std::size_t start = 0; start < neighbors.size(); ++start)
    {
        if (seen[start] != 0)
        {
            continue;
        }
        std::int64_t size = 0;
        seen[start] = 1;
        to_visit.push_back(static_cast<std::int32_t>(start));
        while (!to_visit.empty())
        {
            const std::int32_t tet = to_visit.back();
            to_visit.pop_back();
            ++size;
            for (const std::int32_t next : neighbors[tet])
            {
                if (next >= 0 && seen[next] == 0)
                {
                    seen[next] = 1;
                    to_visit.push_back(next);
                }
            }
        }
        sizes.push_back(size);
    }
    std::sort(sizes.rbegin(), sizes.rend());
    return sizes;
}

void Repair::require_one_body() const
{
    FaceFault fault;
    const TetNeighbors neighbors = tet_neighbors(mesh_, &fault);
    const auto place = [&] { return mesh_.vertices[fault.example[0]]; };
    if (fault.crowded > 0)
    {
        refuse(
            fmt::format("not manifold: {} faces with more than two tets, one at ({:.4g}, {:.4g}, {:.4g}) mm; expected "
                        "one tet on each side of a face",
                        fault.crowded, place().x, place().y, place().z));
    }
    if (fault.same_side > 0)
    {
        refuse(fmt::format("inverted tets: {} faces have both their tets on the same side, which overlap, one at "
                           "({:.4g}, {:.4g}, {:.4g}) mm; expected one tet on each side of a face",
                           fault.same_side, place().x, place().y, place().z));
    }
    const std::vector<std::int64_t> parts = part_sizes(neighbors);
    if (parts.size() > 1)
    {
        const std::span named = std::span(parts).first(std::min(parts.size(), most_parts_named));
        refuse(fmt::format("{} parts that share no face, of {}{} tets{}; expected 1", parts.size(),
                           fmt::join(named, ", "), named.size() < parts.size() ? ", ..." : "", flats_dropped()));
    }
    require_valid_surface(boundary_of(mesh_, neighbors).surface, file_ + ": boundary of the tets" + flats_dropped());
}

void Repair::require_shape()
{
    for (const Tet& tet : mesh_.tets)
    {
        const double ratio = mean_ratio(mesh_.vertices, tet);
        report_.smallest_mean_ratio = std::min(report_.smallest_mean_ratio, ratio);
        report_.sliver_tets += ratio < sliver_mean_ratio ? 1 : 0;
    }
    const auto slivers = static_cast<double>(report_.sliver_tets);
    if (slivers > most_slivers * static_cast<double>(mesh_.tets.size()))
    {
        refuse(fmt::format("slivers: {} of {} tets have a mean ratio below {} (a regular tet has 1); expected at most "
                           "half of them",
                           report_.sliver_tets, mesh_.tets.size(), sliver_mean_ratio));
    }
    say(report_.sliver_tets,
        fmt::format("{} tets are slivers, the worst of mean ratio {:.2g}: kept, but finite elements will need short "
                    "steps",
                    report_.sliver_tets, report_.smallest_mean_ratio));
}

} // namespace

TetMesh require_valid_tets(TetMesh mesh, const std::string& file, TetReport* report)
{
    Repair repair(std::move(mesh), file);
    repair.require_numbers();
    repair.merge_nodes();
    repair.drop_repeated_tets();
    repair.drop_flat_tets();
    repair.flip_left_handed();
    repair.drop_unused_nodes();
    repair.require_shape();
    repair.require_one_body();
    if (report != nullptr)
    {
        *report = repair.report();
    }
    return repair.take_mesh();
}

} // namespace corticle::geometry

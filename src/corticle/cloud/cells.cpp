// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/cloud/cells.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/cloud/line_lattice.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <utility>

namespace corticle::cloud
{

namespace
{

constexpr double reach = 1.25;        ///< farthest owner of a place, in spacings: holes of a relaxed cloud are smaller
constexpr std::int64_t batch = 16384; ///< lines whose shares are held at a time
constexpr double least_volume = 1e-3; ///< of a cell that no line met, in cubic spacings

/// A point seen from a line: the square of its distance at height z is (z - height)² + squared_distance.
struct Site
{
    double height;
    double squared_distance;
    std::int32_t index;
};

/// What one line gives to a point.
struct Share
{
    std::int32_t index;
    double length; ///< [mm]
    Vec3 middle;   ///< [mm]
};

/// A piece of a line: from its start to that of the next, `index` is the nearest point.
struct Piece
{
    Site site;
    double start;
};

/// Height above which b is nearer than a; b is the higher one.
double equidistant_height(const Site& a, const Site& b)
{
    const double rise = b.height - a.height;
    return 0.5 * (a.height + b.height + (b.squared_distance - a.squared_distance) / rise);
}

/// The lower envelope of the sites' parabolas, from below to above (Felzenszwalb & Huttenlocher 2012).
void lower_envelope(std::vector<Site>& sites, std::vector<Piece>& pieces)
{
    std::sort(
        sites.begin(), sites.end(),
        [](const Site& a, const Site& b)
        { return std::tie(a.height, a.squared_distance, a.index) < std::tie(b.height, b.squared_distance, b.index); });
    pieces.clear();
    for (const Site& site : sites)
    {
        if (!pieces.empty() && pieces.back().site.height == site.height)
        {
            continue; // the one already there is nearer at every height
        }
        double start = -std::numeric_limits<double>::infinity();
        while (!pieces.empty())
        {
            start = equidistant_height(pieces.back().site, site);
            if (start > pieces.back().start)
            {
                break;
            }
            pieces.pop_back();
            start = -std::numeric_limits<double>::infinity();
        }
        pieces.push_back({site, start});
    }
}

/// Cuts the inside of a line into the shares of the points nearest to it.
void share_line(double x, double y, std::span<const double> crossings, const std::vector<Piece>& pieces,
                std::vector<Share>& shares)
{
    std::size_t piece = 0;
    for (std::size_t c = 0; c + 1 < crossings.size(); c += 2)
    {
        double from = crossings[c];
        const double to = crossings[c + 1];
        while (from < to && piece < pieces.size())
        {
            const bool last = piece + 1 == pieces.size();
            const double end = last ? to : std::min(to, pieces[piece + 1].start);
            if (end > from)
            {
                shares.push_back({pieces[piece].site.index, end - from, {x, y, 0.5 * (from + end)}});
                from = end;
            }
            if (from < to)
            {
                ++piece;
            }
        }
    }
}

/// Shares of the lines [begin, end).
std::vector<Share> shares_of_lines(const LineLattice& lines, const CellGrid& grid, std::int64_t begin, std::int64_t end)
{
    std::vector<Share> shares;
    std::vector<Site> sites;
    std::vector<Piece> pieces;
    const double reach2 = grid.cell_size() * grid.cell_size();
    for (std::int64_t line = begin; line < end; ++line)
    {
        const std::span<const double> crossings = lines.crossings(line);
        if (crossings.empty())
        {
            continue;
        }
        const double x = lines.x_of(line);
        const double y = lines.y_of(line);
        sites.clear();
        grid.near_line(x, y,
                       [&](std::int32_t index, const Vec3& p)
                       {
                           const double distance2 = (p.x - x) * (p.x - x) + (p.y - y) * (p.y - y);
                           if (distance2 < reach2)
                           {
                               sites.push_back({p.z, distance2, index});
                           }
                       });
        lower_envelope(sites, pieces);
        share_line(x, y, crossings, pieces, shares);
    }
    return shares;
}

} // namespace

Cells cells_of(const TriangleMesh& surface, std::span<const Vec3> points, double spacing, double lines_per_spacing,
               double largest_spacing)
{
    const double step = spacing / lines_per_spacing;
    const LineLattice lines(surface, step);
    const CellGrid grid(points, reach * std::max(spacing, largest_spacing));
    Cells cells{std::vector<double>(points.size(), 0.0), std::vector<Vec3>(points.size())};
    std::vector<double>& volumes = cells.volumes;
    std::vector<Share> shares;
    for (std::int64_t first = 0; first < lines.count(); first += batch)
    {
        parallel_list(std::min(batch, lines.count() - first), shares,
                      [&](std::int64_t begin, std::int64_t end, std::vector<Share>& part)
                      { part = shares_of_lines(lines, grid, first + begin, first + end); });
        for (const Share& share : shares)
        {
            volumes[share.index] += step * step * share.length;
            cells.centroids[share.index] += step * step * share.length * share.middle;
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        cells.centroids[i] = volumes[i] > 0.0 ? cells.centroids[i] / volumes[i] : points[i];
    }
    for (double& volume : volumes)
    {
        volume = std::max(volume, least_volume * spacing * spacing * spacing);
    }
    const double total = enclosed_volume(surface.vertices, surface.triangles);
    const double scale = total / std::accumulate(volumes.begin(), volumes.end(), 0.0);
    for (double& volume : volumes)
    {
        volume *= scale;
    }
    return cells;
}

} // namespace corticle::cloud

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/spectrum.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/metrics/surface/tridiagonal.hpp"
#include "corticle/metrics/surface/vertex_adjacency.hpp"

#include <algorithm>
#include <numbers>
#include <numeric>

namespace corticle::metrics
{

namespace
{

constexpr double kernel_width = 0.2;   ///< of the density of power, in the logarithm of the wavelength
constexpr double same_power = 1e-14;   ///< a remainder below this share of the function is round-off
constexpr double edges_per_wave = 4.0; ///< of the shortest wave a mesh tells
constexpr double lowest_fold_degree = 4.0;

/// The operator M^(-1/2) K M^(-1/2): K has the cotangent weights, M the vertex areas.
struct Operator
{
    VertexLists adjacent;
    std::vector<double> coupling; ///< one per entry of adjacent.index
    std::vector<double> diagonal;
    std::vector<double> root_mass;

    /// Row i of the operator times a vector.
    double row(std::int64_t i, std::span<const double> vector) const
    {
        double sum = diagonal[i] * vector[i];
        for (std::int32_t k = adjacent.begin[i]; k < adjacent.begin[i + 1]; ++k)
        {
            sum -= coupling[k] * vector[adjacent.index[k]];
        }
        return sum;
    }
};

Operator make_operator(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    Operator L{adjacent_vertices(vertices.size(), triangles),
               {},
               std::vector<double>(vertices.size(), 0.0),
               vertex_areas(vertices, triangles)};
    L.coupling.assign(L.adjacent.index.size(), 0.0);
    const auto entry = [&](std::int32_t a, std::int32_t b) -> double&
    {
        const auto begin = L.adjacent.index.begin();
        return L.coupling[std::lower_bound(begin + L.adjacent.begin[a], begin + L.adjacent.begin[a + 1], b) - begin];
    };
    for (const Triangle& t : triangles)
    {
        for (int k = 0; k < 3; ++k)
        {
            const std::int32_t a = t[(k + 1) % 3];
            const std::int32_t b = t[(k + 2) % 3];
            const Vec3 p = vertices[a] - vertices[t[k]];
            const Vec3 q = vertices[b] - vertices[t[k]];
            const double twice_area = norm(cross(p, q));
            const double half_cotangent = twice_area > 0.0 ? 0.5 * dot(p, q) / twice_area : 0.0;
            entry(a, b) += half_cotangent;
            entry(b, a) += half_cotangent;
            L.diagonal[a] += half_cotangent;
            L.diagonal[b] += half_cotangent;
        }
    }
    for (double& m : L.root_mass)
    {
        m = std::sqrt(m);
    }
    for (std::int32_t i = 0; i < L.adjacent.size(); ++i)
    {
        const double own = L.root_mass[i];
        L.diagonal[i] = own > 0.0 ? L.diagonal[i] / (own * own) : 0.0;
        for (std::int32_t k = L.adjacent.begin[i]; k < L.adjacent.begin[i + 1]; ++k)
        {
            const double both = own * L.root_mass[L.adjacent.index[k]];
            L.coupling[k] = both > 0.0 ? L.coupling[k] / both : 0.0;
        }
    }
    return L;
}

struct Jacobi
{
    std::vector<double> diagonal;
    std::vector<double> below;
};

/// -Laplace-Beltrami of a wave from the eigenvalue of the mesh, which is too low by the share k² h² / 16 on regular
/// triangles of edge h: error of fourth order on even meshes.
double without_dispersion(double eigenvalue, double squared_edge)
{
    const double share = eigenvalue * squared_edge / 16.0;
    return eigenvalue * (1.0 + share + 2.0 * share * share);
}

/// Squared edge of an equilateral triangle of the mean area [mm²].
double squared_mean_edge(double area, std::size_t triangles)
{
    return 4.0 / std::numbers::sqrt3 * area / static_cast<double>(triangles);
}

/// Lanczos process from a unit vector.
Jacobi lanczos(const Operator& L, std::vector<double> now, int steps)
{
    Jacobi matrix;
    std::vector<double> before(now.size(), 0.0);
    std::vector<double> next(now.size());
    double coupling = 0.0;
    for (int step = 0; step < steps; ++step)
    {
        const double own = parallel_sum(std::ssize(now),
                                        [&](std::int64_t i)
                                        {
                                            next[i] = L.row(i, now);
                                            return now[i] * next[i];
                                        });
        const double square = parallel_sum(std::ssize(now),
                                           [&](std::int64_t i)
                                           {
                                               next[i] -= own * now[i] + coupling * before[i];
                                               return next[i] * next[i];
                                           });
        matrix.diagonal.push_back(own);
        coupling = std::sqrt(square);
        if (step + 1 == steps || coupling <= same_power * matrix.diagonal[0])
        {
            break;
        }
        matrix.below.push_back(coupling);
        for (double& value : next)
        {
            value /= coupling;
        }
        std::swap(before, now); // before <- now, now <- next, next <- scratch
        std::swap(now, next);
    }
    return matrix;
}

} // namespace

std::vector<SpectralLine> laplace_beltrami_spectrum(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                                    std::span<const double> values, int steps)
{
    const Operator L = make_operator(vertices, triangles);
    double area = 0.0;
    double integral = 0.0;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        const double a = L.root_mass[i] * L.root_mass[i];
        area += a;
        integral += a * values[i];
    }
    std::vector<double> start(values.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
        start[i] = L.root_mass[i] * (values[i] - integral / area);
    }
    const double size = std::sqrt(std::inner_product(start.begin(), start.end(), start.begin(), 0.0));
    if (!(size > 0.0))
    {
        return {};
    }
    for (double& s : start)
    {
        s /= size;
    }
    const Jacobi matrix = lanczos(L, std::move(start), steps);
    const Quadrature measure = gauss_quadrature(matrix.diagonal, matrix.below);
    std::vector<SpectralLine> spectrum;
    for (std::size_t k = 0; k < measure.nodes.size(); ++k)
    {
        if (measure.nodes[k] > 0.0) // round-off of the eigenvalue 0 may fall below
        {
            const double eigenvalue = without_dispersion(measure.nodes[k], squared_mean_edge(area, triangles.size()));
            spectrum.push_back(
                {2.0 * std::numbers::pi / std::sqrt(eigenvalue), measure.weights[k] * size * size / area});
        }
    }
    std::sort(spectrum.begin(), spectrum.end(),
              [](const SpectralLine& a, const SpectralLine& b) { return a.wavelength > b.wavelength; });
    return spectrum;
}

FoldBand fold_band(std::span<const Vec3> vertices, std::span<const Triangle> triangles)
{
    const double area = surface_area(vertices, triangles);
    const double edge = std::sqrt(squared_mean_edge(area, triangles.size()));
    const double radius = std::sqrt(area / (4.0 * std::numbers::pi));
    return {edges_per_wave * edge,
            2.0 * std::numbers::pi * radius / std::sqrt(lowest_fold_degree * (lowest_fold_degree + 1.0))};
}

double dominant_wavelength(std::span<const SpectralLine> spectrum, const FoldBand& band)
{
    constexpr double tolerance = 1.02;        // the discrete operator's own error at the ends of the band
    std::vector<std::array<double, 2>> lines; // logarithm of the wavelength, power
    for (const SpectralLine& line : spectrum)
    {
        if (line.power > 0.0 && line.wavelength * tolerance >= band.shortest &&
            line.wavelength <= band.longest * tolerance)
        {
            lines.push_back({std::log(line.wavelength), line.power});
        }
    }
    double densest = 0.0;
    double centre = 0.0;
    for (const auto& [at, own] : lines)
    {
        double density = 0.0;
        double moment = 0.0;
        for (const auto& [other, power] : lines)
        {
            const double away = (other - at) / kernel_width;
            const double share = power * std::exp(-0.5 * away * away);
            density += share;
            moment += share * other;
        }
        const double wave_number = 2.0 * std::numbers::pi * std::exp(-at);
        const double height = 2.0 * std::sqrt(density) / (wave_number * wave_number);
        if (density > densest && height >= band.least_height)
        {
            densest = density;
            centre = moment / density;
        }
    }
    return densest > 0.0 ? std::exp(centre) : 0.0;
}

} // namespace corticle::metrics

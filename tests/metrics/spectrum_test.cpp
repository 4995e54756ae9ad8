// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface/spectrum.hpp"

#include "corticle/metrics/surface/spherical_harmonics.hpp"
#include "corticle/metrics/surface/tridiagonal.hpp"
#include "metrics/turned_surfaces.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <complex>
#include <numeric>

namespace corticle
{
namespace
{

using std::numbers::pi;

constexpr double R = 12.496;

/// Wavelength of a degree on a sphere [mm] (Jeans 1923).
double wavelength_of_degree(double radius, int degree)
{
    return 2.0 * pi * radius / std::sqrt(static_cast<double>(degree) * (degree + 1.0));
}

/// A sectoral harmonic of degree l along an axis.
double sectoral(int l, const Vec3& n)
{
    return std::pow(std::complex(n.x, n.y), l).real();
}

struct Sphere
{
    TriangleMesh mesh = geometry::make_ellipsoid({R, R, R}, 0.6); ///< as of 45,000 particles
    std::vector<Vec3> directions;
    std::vector<double> areas = vertex_areas(mesh.vertices, mesh.triangles);

    Sphere()
    {
        for (const Vec3& v : mesh.vertices)
        {
            directions.push_back(normalized(v));
        }
    }
    static const Sphere& shared()
    {
        static const Sphere sphere;
        return sphere;
    }
    template <class Function>
    std::vector<double> sample(Function&& function) const
    {
        std::vector<double> values;
        std::transform(directions.begin(), directions.end(), std::back_inserter(values), function);
        return values;
    }
    double dominant(std::span<const double> values) const
    {
        return metrics::dominant_wavelength(metrics::laplace_beltrami_spectrum(mesh.vertices, mesh.triangles, values),
                                            metrics::fold_band(mesh.vertices, mesh.triangles));
    }
};

TEST(SphericalHarmonics, FindAnImposedDegreeExactly)
{
    const Sphere& sphere = Sphere::shared();
    for (const int l : {1, 4, 9, 17})
    {
        const auto values = sphere.sample([l](const Vec3& n) { return 3.0 + std::legendre(l, 0.6 * n.x - 0.8 * n.z); });
        const std::vector<double> power = metrics::power_by_degree(sphere.directions, values, sphere.areas, 20);
        EXPECT_EQ(metrics::dominant_degree(power), l);
        EXPECT_NEAR(power[0], 9.0, 0.01);
        EXPECT_NEAR(power[l] * (2.0 * l + 1.0), 1.0, 0.02); // mean square of a Legendre polynomial: 1 / (2 l + 1)
        EXPECT_LT(std::accumulate(power.begin() + 1, power.end(), 0.0) - power[l], 0.01 * power[l]);
    }
}

TEST(SphericalHarmonics, WavelengthOfJeans)
{
    EXPECT_NEAR(wavelength_of_degree(R, 9), 2.0 * pi * R / std::sqrt(90.0), 1e-12);
    EXPECT_EQ(metrics::dominant_degree(std::vector<double>{5.0, 0.0, 0.0}), 0);
}

TEST(Spectrum, AnImposedHarmonicIsOneLineOfItsWavelength)
{
    const Sphere& sphere = Sphere::shared();
    for (const int l : {5, 9, 14})
    {
        const auto values = sphere.sample([l](const Vec3& n) { return 2.0 + sectoral(l, n); });
        const double found = sphere.dominant(values);
        fmt::print("degree {}: wavelength {:.4f} mm, exact {:.4f} mm\n", l, found, wavelength_of_degree(R, l));
        EXPECT_NEAR(found / wavelength_of_degree(R, l), 1.0, 0.005);
    }
}

TEST(Spectrum, PowersAreTheMeanSquareAndTheStrongerOfTwoHarmonicsWins)
{
    const Sphere& sphere = Sphere::shared();
    const auto values =
        sphere.sample([](const Vec3& n) { return std::legendre(8, n.y) + 2.0 * std::legendre(13, n.x); });
    const auto spectrum = metrics::laplace_beltrami_spectrum(sphere.mesh.vertices, sphere.mesh.triangles, values);
    double total = 0.0;
    double near_8 = 0.0;
    double near_13 = 0.0;
    for (const metrics::SpectralLine& line : spectrum)
    {
        total += line.power;
        near_8 += std::abs(line.wavelength / wavelength_of_degree(R, 8) - 1.0) < 0.02 ? line.power : 0.0;
        near_13 += std::abs(line.wavelength / wavelength_of_degree(R, 13) - 1.0) < 0.02 ? line.power : 0.0;
    }
    EXPECT_NEAR(total, 1.0 / 17.0 + 4.0 / 27.0, 0.002);
    EXPECT_NEAR(near_8, 1.0 / 17.0, 0.001);
    EXPECT_NEAR(near_13, 4.0 / 27.0, 0.003);
    // The weaker one, 0.47 away in the logarithm, pulls a little on the mean under the kernel of width 0.2.
    EXPECT_NEAR(sphere.dominant(values) / wavelength_of_degree(R, 13), 1.0, 0.02);
}

TEST(Spectrum, OfWavesOnACylinder)
{
    const TriangleMesh mesh = test::cylinder(5.0, 40.0, 0.5);
    std::vector<double> values;
    for (const Vec3& x : mesh.vertices)
    {
        values.push_back(std::cos(2.0 * pi * x.z / 4.0)); // 10 waves; on the end faces it is constant
    }
    const double wavelength =
        metrics::dominant_wavelength(metrics::laplace_beltrami_spectrum(mesh.vertices, mesh.triangles, values),
                                     metrics::fold_band(mesh.vertices, mesh.triangles));
    EXPECT_NEAR(wavelength / 4.0, 1.0, 0.02);
}

TEST(Spectrum, OfAConstantIsEmptyAndTheShapeOfTheBodyIsNoFold)
{
    const Sphere& sphere = Sphere::shared();
    const auto constant = sphere.sample([](const Vec3&) { return 1.0; });
    EXPECT_EQ(sphere.dominant(constant), 0.0);
    const auto egg = sphere.sample([](const Vec3& n) { return 5.0 * std::legendre(2, n.z) + sectoral(10, n); });
    EXPECT_NEAR(sphere.dominant(egg) / wavelength_of_degree(R, 10), 1.0, 0.01);
}

TEST(GaussQuadrature, OfLegendreIsExactForPolynomials)
{
    constexpr int points = 12;
    std::vector<double> below;
    for (int k = 1; k < points; ++k)
    {
        below.push_back(k / std::sqrt(4.0 * k * k - 1.0));
    }
    const metrics::Quadrature q = metrics::gauss_quadrature(std::vector<double>(points, 0.0), below);
    for (int power = 0; power < 2 * points; ++power)
    {
        double sum = 0.0;
        for (int k = 0; k < points; ++k)
        {
            sum += q.weights[k] * std::pow(q.nodes[k], power);
        }
        EXPECT_NEAR(sum, power % 2 == 0 ? 1.0 / (power + 1.0) : 0.0, 1e-14) << power; // over [-1, 1], weight 1/2
    }
}

} // namespace
} // namespace corticle

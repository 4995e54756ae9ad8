// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::metrics
{

/// Part of the mean square of a function on a surface.
struct SpectralLine
{
    double wavelength = 0.0; ///< 2 pi / sqrt(eigenvalue of -Laplace-Beltrami) [mm]
    double power = 0.0;      ///< share of the area-weighted mean square of the function, its mean taken off
};

/// Spectrum of a function at the vertices of a closed surface by eigenfunctions of the Laplace-Beltrami operator
/// (cotangent weights, Pinkall & Polthier 1993; lumped masses, their dispersion on regular triangles
/// taken out), longest wavelength first.
///
/// The eigenfunctions themselves are not computed: `steps` steps of the Lanczos process that starts from the function
/// give the Gauss quadrature of its spectral measure (Golub & Meurant 1994, Matrices, moments and quadrature). The
/// powers and moments are exact, and a function that is one eigenfunction gives one line; lines closer together than
/// the steps tell apart are drawn into one.
/// @param values  any unit, one per vertex; powers are in its square
std::vector<SpectralLine> laplace_beltrami_spectrum(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                                    std::span<const double> values, int steps = 160);

/// Wavelengths that count as folds [mm].
struct FoldBand
{
    double shortest = 0.0;
    double longest = 0.0;
    double least_height = 0.0; ///< root mean square height that the waves about a wavelength must have [mm]
};

/// From four mean edges of the mesh to the wavelength of degree 4 on the sphere of equal area: longer waves are the
/// shape of the body (Germanaud et al. 2012, NeuroImage 63, sets the first bands of a brain apart likewise).
FoldBand fold_band(std::span<const Vec3> vertices, std::span<const Triangle> triangles);

/// Wavelength around which the power of a spectrum of the mean curvature H is densest over the logarithm of the
/// wavelength, within a band [mm]; 0 where the band holds no power. Waves of height u have H = u k² / 2.
double dominant_wavelength(std::span<const SpectralLine> spectrum, const FoldBand& band);

} // namespace corticle::metrics

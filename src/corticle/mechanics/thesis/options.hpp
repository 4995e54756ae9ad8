// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle::thesis
{

/// Which equations of motion the particles follow.
enum class Formulation
{
    corrected, ///< those of docs/theory/tlsph.md
    thesis     ///< those the thesis prints
};

/// How growth enters the stress.
enum class GrowthEntry
{
    multiplied, ///< F G in place of F (thesis eqs. 22 and 23)
    divided     ///< F G^-1, the stress pulled back: P = det G P_e G^-T
};

/// How stress becomes force.
enum class ForceForm
{
    difference,  ///< sum_j V_j (P_j - P_i) grad W (thesis eq. 9)
    conservative ///< minus the gradient of the energy
};

/// Gradient that F and the force are made with.
enum class KernelGradient
{
    plain,        ///< of the kernel, on positions (thesis eq. 10)
    displacement, ///< of the kernel, on displacements: F = I + sum_j V_j u_ij grad W, which is I at rest
    corrected     ///< times L_i, exact for affine motion
};

/// The thesis's equations, and what puts them right one by one (keys under [thesis]).
struct ThesisOptions
{
    GrowthEntry growth = GrowthEntry::multiplied;
    ForceForm force = ForceForm::difference;
    KernelGradient gradient = KernelGradient::plain;
    double viscosity_alpha = 0.04; ///< linear artificial viscosity (thesis eq. 7)
    double viscosity_beta = 0.08;  ///< quadratic

    bool has_viscosity() const { return viscosity_alpha > 0.0 || viscosity_beta > 0.0; }
};

} // namespace corticle::thesis

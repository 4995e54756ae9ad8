// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/remodelling_options.hpp"
#include "corticle/material/tissue_kind.hpp"

#include <optional>

namespace corticle::material
{

enum class Layer
{
    smooth,
    binary
};

enum class BulkRule
{
    per_tissue,
    uniform
};

/// Course of growth in t.
enum class GrowthLaw
{
    linear,
    gompertz
};

/// Where growth of the tissues comes from (key growth.law).
enum class GrowthSource
{
    keys,  ///< alpha_t, alpha_r and alpha_white of [tissue], by t
    fetal, ///< by week, of a fetal brain
    table  ///< by week, of a file
};

/// Which normal growth is tangential to.
enum class NormalFrame
{
    reference, ///< of the surface before it deformed
    current    ///< of the deformed layers
};

/// Thickness of the cortex by name: the rows of thickness_presets().
enum class ThicknessPreset
{
    none,
    linear_2_5
};

/// Tissue parameters (keys under [tissue]).
struct TissueOptions
{
    Layer layer = Layer::smooth;
    ThicknessPreset thickness_preset = ThicknessPreset::none; ///< sets the two below
    double thickness_mm = 1.674;                              ///< H_i
    double thickness_rate_mm = 0.0;                           ///< beta: H(t) = H_i + beta t
    double lambda = 0.0;     ///< > 0 with layer = "binary" on a sphere or ellipsoid: cortex where sum (x/r)² >= lambda
                             ///< (thesis eq. 24); 0: thickness decides
    double mu_cortex = 0.86; ///< shear modulus [mu_w]
    double mu_white = 1.0;
    double mu_deep = 1.0;
    double mu_ventricle = 0.1;
    double mu_still = 1.0;
    BulkRule bulk = BulkRule::per_tissue;
    double bulk_modulus = 5.0;                   ///< K / mu (per_tissue) or K itself (uniform)
    PerTissue<std::optional<double>> bulk_ratio; ///< K / mu of a tissue; not given: as bulk_modulus says
    double alpha_t = 1.8284271247461903;         ///< sqrt(8) - 1
    double alpha_r = 0.0;                        ///< growth of the cortex along the normal
    double alpha_white = 0.0;                    ///< growth of the white matter, in all directions
    GrowthSource growth_source = GrowthSource::keys;
    GrowthLaw growth_law = GrowthLaw::linear;
    double growth_onset = 0.0; ///< [t]
    double growth_rate = 1.0;  ///< [1/t]
    NormalFrame normal = NormalFrame::reference;
    double barrier_J = 0.3;         ///< elastic volume ratio below which the barrier acts; 0: none
    RemodellingOptions remodelling; ///< keys under [fibres], [relaxation] and [stress_growth]
};

} // namespace corticle::material

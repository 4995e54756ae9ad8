// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/tissue_parameters.hpp"

#include "corticle/config/parameters/parameter_builders.hpp"

#include <fmt/format.h>

namespace corticle::config
{

using namespace detail;

#define CORTICLE_MEMBER(path) ([](auto& options) -> auto& { return options.path; })

namespace
{

std::string tissue_in_words(const std::string& tissue)
{
    return tissue == "cortex"  ? "the cortical plate"
           : tissue == "white" ? "white matter"
           : tissue == "deep"  ? "deep grey matter"
           : tissue == "still" ? "tissue that does not grow"
                               : "the ventricles";
}

std::string thickness_preset_sentence()
{
    std::string sentence = "A thickness by name instead of the two keys below:";
    std::string_view separator = " ";
    for (const material::PresetThickness& row : material::thickness_presets())
    {
        sentence +=
            fmt::format("{}{} is {} mm + {} mm t ({})", separator, row.name, row.initial_mm, row.rate_mm, row.source);
        separator = "; ";
    }
    return sentence + ".";
}

/// K / mu of one tissue.
template <class Access>
Parameter bulk_ratio(const std::string& tissue, Access access)
{
    return with_example(
        parameter("tissue.bulk_ratio_" + tissue, "mu", between(0.1, 10000.0),
                  fmt::format("Bulk modulus of {} in its shear moduli; not given: as bulk_modulus says.",
                              tissue_in_words(tissue)),
                  access),
        "20.0");
}

/// Labels of one tissue.
template <class Access>
Parameter tissue_labels(const std::string& tissue, Access access)
{
    return parameter("tissue.labels." + tissue, "", between(-2147483648.0, 2147483647.0),
                     fmt::format("Labels of {} in the label volume that geometry.file names{}.",
                                 tissue_in_words(tissue),
                                 tissue == "cortex" ? "; empty: cortex is what is near the surface" : ""),
                     access);
}

} // namespace

std::vector<Parameter> growth_parameters()
{
    return {
        parameter(
            "growth.law", "", {},
            "Where growth comes from: the keys alpha_t, alpha_r and alpha_white of [tissue] by t; a calibrated law "
            "of the tissues of a fetal brain by week; or growth.table.",
            CORTICLE_MEMBER(tissue.growth_source)),
        path("growth.table",
             "CSV with columns week, tissue, tangential and radial: linear growth of each tissue by week, against any "
             "week.",
             CORTICLE_MEMBER(growth_table)),
    };
}

std::vector<Parameter> tissue_parameters()
{
    return {
        parameter("tissue.layer", "", {}, "Transition from cortex to white matter.", CORTICLE_MEMBER(tissue.layer)),
        parameter("tissue.thickness_preset", "", {}, thickness_preset_sentence(),
                  CORTICLE_MEMBER(tissue.thickness_preset)),
        without_thickness_preset(parameter("tissue.thickness_mm", "mm", above(0.0, 100.0),
                                           "Thickness of the cortex at t = 0.", CORTICLE_MEMBER(tissue.thickness_mm))),
        without_thickness_preset(parameter("tissue.thickness_rate_mm", "mm", between(-100.0, 100.0),
                                           "Change of the thickness from t = 0 to t = 1.",
                                           CORTICLE_MEMBER(tissue.thickness_rate_mm))),
        parameter("tissue.lambda", "", between(0.0, 0.999),
                  "Above 0: cortex is where the squared scaled radius of a sphere or ellipsoid reaches this "
                  "(binary layer only; of another body the scaled extents are taken, thesis eq. 24); 0: the thickness "
                  "decides.",
                  CORTICLE_MEMBER(tissue.lambda)),
        parameter("tissue.mu_cortex", "mu_w", between(0.001, 1000.0), "Shear modulus of the cortex.",
                  CORTICLE_MEMBER(tissue.mu_cortex)),
        parameter("tissue.mu_white", "mu_w", between(0.001, 1000.0), "Shear modulus of the white matter.",
                  CORTICLE_MEMBER(tissue.mu_white)),
        parameter("tissue.mu_deep", "mu_w", between(0.001, 1000.0), "Shear modulus of labelled deep grey matter.",
                  CORTICLE_MEMBER(tissue.mu_deep)),
        parameter("tissue.mu_ventricle", "mu_w", between(0.001, 1000.0),
                  "Shear modulus of labelled ventricles, a soft solid in place of their fluid.",
                  CORTICLE_MEMBER(tissue.mu_ventricle)),
        parameter("tissue.mu_still", "mu_w", between(0.001, 1000.0),
                  "Shear modulus of labelled tissue that does not grow.", CORTICLE_MEMBER(tissue.mu_still)),
        parameter("tissue.bulk", "", {}, "Whether the bulk modulus follows the shear modulus or is one constant.",
                  CORTICLE_MEMBER(tissue.bulk)),
        parameter("tissue.bulk_modulus", "mu or mu_w", between(0.1, 10000.0),
                  "Bulk modulus: in shear moduli of the tissue (per_tissue) or itself (uniform).",
                  CORTICLE_MEMBER(tissue.bulk_modulus)),
        bulk_ratio("cortex", CORTICLE_MEMBER(tissue.bulk_ratio[0])),
        bulk_ratio("white", CORTICLE_MEMBER(tissue.bulk_ratio[1])),
        bulk_ratio("deep", CORTICLE_MEMBER(tissue.bulk_ratio[2])),
        bulk_ratio("ventricle", CORTICLE_MEMBER(tissue.bulk_ratio[3])),
        bulk_ratio("still", CORTICLE_MEMBER(tissue.bulk_ratio[4])),
        without_growth_by_week(parameter("tissue.alpha_t", "", between(0.0, 10.0),
                                         "Tangential growth of the cortex at t = 1.", CORTICLE_MEMBER(tissue.alpha_t))),
        without_growth_by_week(parameter("tissue.alpha_r", "", between(0.0, 10.0),
                                         "Growth of the cortex along the normal at t = 1; equal to alpha_t: isotropic.",
                                         CORTICLE_MEMBER(tissue.alpha_r))),
        without_growth_by_week(parameter("tissue.alpha_white", "", between(0.0, 10.0),
                                         "Growth of the white matter at t = 1, in all directions.",
                                         CORTICLE_MEMBER(tissue.alpha_white))),
        without_growth_by_week(parameter(
            "tissue.growth_law", "", {},
            "Course of growth: rate (t - onset), or Gompertz's curve with that line for its steepest tangent.",
            CORTICLE_MEMBER(tissue.growth_law))),
        without_growth_by_week(parameter("tissue.growth_onset", "", between(-10.0, 1.0), "t at which growth sets in.",
                                         CORTICLE_MEMBER(tissue.growth_onset))),
        without_growth_by_week(parameter("tissue.growth_rate", "", above(0.0, 100.0),
                                         "Slope of growth in t, the largest one with gompertz.",
                                         CORTICLE_MEMBER(tissue.growth_rate))),
        parameter("tissue.normal", "", {},
                  "Growth is tangential to the layers of the reference state or of the current one.",
                  CORTICLE_MEMBER(tissue.normal)),
        parameter("tissue.barrier_J", "", between(0.0, 0.95),
                  "Elastic volume ratio below which a barrier resists crushing; 0: none.",
                  CORTICLE_MEMBER(tissue.barrier_J)),
        tissue_labels("cortex", CORTICLE_MEMBER(labels[0])),
        tissue_labels("white", CORTICLE_MEMBER(labels[1])),
        tissue_labels("deep", CORTICLE_MEMBER(labels[2])),
        tissue_labels("ventricle", CORTICLE_MEMBER(labels[3])),
        tissue_labels("still", CORTICLE_MEMBER(labels[4])),
    };
}

#undef CORTICLE_MEMBER

} // namespace corticle::config

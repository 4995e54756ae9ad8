// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/growth.hpp"
#include "corticle/material/material_point.hpp"
#include "corticle/material/size.hpp"
#include "corticle/material/tissue_growth.hpp"
#include "corticle/mesh/share.hpp"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace corticle::material
{

struct RemodellingView;

/// Growth that the body as imaged has behind it.
struct PastGrowth
{
    double tangential; ///< g_t at the start [-]
    double radial;     ///< g_r at the start [-]
};

/// Maps of the growth that goes on at some times; between them it is interpolated, before and after them constant.
struct GrowthMaps
{
    std::vector<double> times;               ///< [t], increasing
    std::vector<std::vector<double>> values; ///< of every point, one vector for each time [-]
    double from = 0.0;                       ///< t from which maps count: where growth begins

    /// A number and its rate.
    struct Mean
    {
        double value;
        double rate; ///< per t
    };
    /// Mean of the maps from the beginning of growth to t, so that growth at a constant rate times this mean is what
    /// the maps add up to.
    Mean mean(std::size_t i, double t) const;
};

/// What the tissue is at every material point; constant. Arrays that are empty cost nothing: the one value of the
/// options holds everywhere.
struct TissueFields
{
    std::vector<double> volume;         ///< reference volume [mm³]
    std::vector<double> depth;          ///< y, reference distance to the surface [mm]
    std::vector<Vec3> normal;           ///< n, unit, reference
    std::vector<double> mapped_rate;    ///< m as maps give it [-]
    std::vector<double> regional_rate;  ///< m, the imperfection included [-]
    GrowthMaps growth_maps;             ///< by which m is multiplied, or none
    std::vector<double> growth_onset;   ///< [t], or empty
    std::vector<double> growth_rate;    ///< [1/t], or empty
    std::vector<double> region;         ///< label of the region, for files alone, or empty
    std::vector<double> thickness;      ///< H_i of the closest surface point [mm], or empty
    std::vector<double> given_theta;    ///< a cortex that does not follow from depth and thickness [-], or empty
    std::vector<double> cortex_inside;  ///< distance from the inner boundary of a labelled cortex, positive in the
                                        ///< cortex [mm], or empty
    std::vector<TissueKind> kind;       ///< tissue of what is not cortex, or empty: white matter, with the growth of
                                        ///< the keys and one K / mu
    std::optional<TissueGrowth> growth; ///< by week, or none: by the keys; needs kind
    std::vector<Vec3> fibre;            ///< direction of the fibres, unit, reference, or empty
    std::vector<Vec3> given_fibre;   ///< directions in place of those of the case, of any length, 0: no fibre; or empty
    std::vector<double> white_share; ///< of white matter at the start, which fibres run through and which grows by
                                     ///< stress [-], or empty where nothing asks for it
};

/// What of the tissue goes with growth time; follows from fields, options and t.
struct TissueState
{
    std::vector<double> theta;          ///< cortex share at the current t [-]
    std::vector<double> theta_rate;     ///< dtheta/dt of a smooth layer that moves, or empty
    std::vector<PastGrowth> past;       ///< or empty: none
    std::vector<TissueGrowthAt> by_law; ///< growth since the start by a law from outside, or empty: the case's
};

/// H_i + beta t of material point i [mm]: divided by s(t), the thickness in the reference state.
inline double thickness_at(const TissueFields& fields, const TissueOptions& options, std::size_t i, double t)
{
    return (fields.thickness.empty() ? options.thickness_mm : fields.thickness[i]) + options.thickness_rate_mm * t;
}

/// Whether theta changes with t.
bool layer_moves(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size);

/// Sets theta(y, H(t)), H(t) = (H_i + beta t) / s(t), with s the scale of the reference state (thesis eqs. 11 and 14;
/// s = 1 without a length law), and its rate where H moves a smooth layer.
/// @param size   by which the cortex thins; without a law it does not
/// @param share  whose points are set; of a sharp layer, which depends on all of them, all are
void set_layer(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t,
               const Share& share, TissueState& state);
inline void set_layer(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t,
                      TissueState& state)
{
    set_layer(fields, options, size, t, Share(std::ssize(fields.depth)), state);
}

/// The tissue as growth begins at t, where the body is free of stress: growth is relative to the growth at t,
/// G(t') G(t)^-1, so that a body imaged at t > 0 starts at rest.
TissueState start_tissue(const TissueFields& fields, const TissueOptions& options, const ReferenceSize& size, double t);

/// The tissue at one time, as the methods see it: refers to what others own.
struct Tissue
{
    const TissueOptions& options;
    const TissueFields& fields;
    const TissueState& state;
    const RemodellingView* remodelling = nullptr; ///< of tissue with a history

    /// Whether growth is g = 1 + alpha_t theta m t in the reference planes and nothing else: what point() and
    /// growth_normal() then give needs no more than material_point and the normals.
    bool grows_plainly() const { return remodelling == nullptr && has_plain_points(); }
    /// The same but for growth by stress.
    bool has_plain_points() const;

    /// Moduli and growth of particle i at t, but for growth by stress.
    MaterialPoint point(std::size_t i, double t) const
    {
        MaterialPoint point = is_by_tissue() ? labelled_point(i, t) : point_by_theta(i, t);
        if (!state.by_law.empty())
        {
            const TissueGrowthAt& law = state.by_law[i];
            point.growth = law.tangential;
            point.growth_rate = law.tangential_rate;
            point.radial_growth = law.radial;
            point.radial_growth_rate = law.radial_rate;
        }
        else if (!state.past.empty())
        {
            point.growth /= state.past[i].tangential;
            point.growth_rate /= state.past[i].tangential;
            point.radial_growth /= state.past[i].radial;
            point.radial_growth_rate /= state.past[i].radial;
        }
        return point;
    }

    /// Whether tissues differ by more than theta says, or grow by week.
    bool is_by_tissue() const { return !fields.kind.empty(); }

    /// The unit normal that growth of particle i is tangential to, in the reference frame.
    /// @param F  deformation gradient of the particle
    Vec3 growth_normal(std::size_t i, const Mat3& F) const
    {
        return options.normal == NormalFrame::reference ? fields.normal[i] : current_normal(F, fields.normal[i]);
    }

  private:
    GrowthCourse course_of(std::size_t i) const
    {
        return {options.growth_law, fields.growth_onset.empty() ? options.growth_onset : fields.growth_onset[i],
                fields.growth_rate.empty() ? options.growth_rate : fields.growth_rate[i]};
    }
    /// m, and how maps in time change it.
    GrowthMaps::Mean regional_rate(std::size_t i, double t) const
    {
        const double m = fields.regional_rate[i];
        if (fields.growth_maps.times.empty())
        {
            return {m, 0.0};
        }
        const GrowthMaps::Mean maps = fields.growth_maps.mean(i, t);
        return {m * maps.value, m * maps.rate};
    }
    // Both as they grow from t = 0, whatever is past.
    MaterialPoint point_by_theta(std::size_t i, double t) const
    {
        const GrowthCourse course = course_of(i);
        const GrowthMaps::Mean m = regional_rate(i, t);
        MaterialPoint point = material_point(options, state.theta[i], m.value, course.value(t));
        const double slope = course.slope(t);
        point.growth_rate *= slope;
        point.radial_growth_rate *= slope;
        if (!state.theta_rate.empty())
        {
            const double per_theta = state.theta_rate[i] * m.value * course.value(t);
            point.growth_rate += per_theta * (options.alpha_t - options.alpha_white);
            point.radial_growth_rate += per_theta * (options.alpha_r - options.alpha_white);
            point.shear_rate = state.theta_rate[i] * (options.mu_cortex - options.mu_white);
            point.bulk_rate = options.bulk == BulkRule::per_tissue ? options.bulk_modulus * point.shear_rate : 0.0;
        }
        if (m.rate != 0.0)
        {
            const MaterialPoint by_maps = material_point(options, state.theta[i], m.rate, course.value(t));
            point.growth_rate += by_maps.growth - 1.0;
            point.radial_growth_rate += by_maps.radial_growth - 1.0;
        }
        return point;
    }
    /// theta of the cortex, 1 - theta of the tissue that is there: moduli and growth are those of the two by share.
    MaterialPoint labelled_point(std::size_t i, double t) const;
};

/// Reference volume of every tissue [mm³]: the cortex by its share theta, the rest as its kind; without kinds it is
/// white matter.
PerTissue<double> tissue_volumes(const TissueFields& fields, std::span<const double> theta);

/// Moduli of a tissue [mu_w].
struct Moduli
{
    double shear; ///< mu
    double bulk;  ///< K
};
Moduli moduli_of(const TissueOptions& options, TissueKind kind);

/// Pressure-wave speed of the white matter at density 1: sqrt(K + 4 mu / 3).
double wave_speed(const TissueOptions& options);

} // namespace corticle::material

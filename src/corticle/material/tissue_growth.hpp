// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/clock.hpp"
#include "corticle/material/tissue_kind.hpp"

#include <span>
#include <vector>

namespace corticle::material
{

/// A row of a growth table: linear growth of a tissue at a week, against any week of reference.
struct GrowthRow
{
    double week; ///< gestational age [weeks]
    TissueKind tissue;
    double tangential; ///< in the plane of the layer [-]
    double radial;     ///< along the normal [-]
};

/// Growth of one tissue at t, relative to the start.
struct TissueGrowthAt
{
    double tangential = 1.0;      ///< g_t [-]
    double radial = 1.0;          ///< g_r [-]
    double tangential_rate = 0.0; ///< dg_t/dt
    double radial_rate = 0.0;     ///< dg_r/dt
};

/// Courses of growth of the tissues by week. Between rows growth goes on at a constant rate in per cent of what is
/// there (ln g linear in the week); a tissue without rows does not grow.
class TissueGrowth
{
  public:
    /// Without courses, which each_array brings from another one.
    TissueGrowth() = default;
    /// @param rows  in any order   @param start_week  of the body as given, where all growth is 1
    /// @throws InputError where the rows of a tissue do not reach from start_week to end_week, are two of one week, or
    /// are not positive
    TissueGrowth(std::span<const GrowthRow> rows, GestationalClock clock, double start_week, double end_week);

    TissueGrowthAt at(TissueKind tissue, double t) const;

    /// How fast a body would lengthen if its parts grew without holding each other back, d ln L/dt: a third of what its
    /// grown volume V = sum of V_k g_t² g_r does.
    /// @param volumes  V_k, reference volumes of the tissues
    double mean_rate(const PerTissue<double>& volumes, double t) const;

    /// Calls act for all arrays and numbers.
    template <class Act>
    void each_array(Act&& act)
    {
        act(start_);
        act(step_);
        for (Course& course : courses_)
        {
            act(course.tangential);
            act(course.radial);
        }
    }

  private:
    /// g at evenly spaced t.
    struct Course
    {
        std::vector<double> tangential;
        std::vector<double> radial;
    };

    double start_ = 0.0; ///< [t]
    double step_ = 1.0;  ///< [t]
    PerTissue<Course> courses_;
};

/// Growth of the tissues of a fetal brain from week 20 to 40: see docs/theory/growth-law.md.
/// @param start_week  of the body as given, within these weeks
std::vector<GrowthRow> fetal_growth(double start_week);

} // namespace corticle::material

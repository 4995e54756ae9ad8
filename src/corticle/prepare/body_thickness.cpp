// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_thickness.hpp"

#include "corticle/prepare/labelled_tissue.hpp"
#include "corticle/prepare/thesis_choices.hpp"

#include <algorithm>
#include <numeric>

namespace corticle::prepare
{

double thickness_at(const PreparationOptions& options, double thickness, double t)
{
    return (thickness + options.tissue.thickness_rate_mm * t) / model::cortex_size(options).scale(t);
}

double least_thickness(const PreparationOptions& options, const model::Model& model)
{
    if (has_layer_by_lambda(options))
    {
        return thickness_by_lambda(options, model);
    }
    if (has_labelled_cortex(options))
    {
        return labelled_thickness(model);
    }
    const std::vector<double>& local = model.tissue.thickness;
    const double thickness =
        local.empty() ? options.tissue.thickness_mm : *std::min_element(local.begin(), local.end());
    return std::min(thickness_at(options, thickness, options.time.start),
                    thickness_at(options, thickness, options.time.end));
}

double mean_thickness(const PreparationOptions& options, const model::Model& model)
{
    if (has_layer_by_lambda(options))
    {
        return thickness_by_lambda(options, model);
    }
    if (has_labelled_cortex(options))
    {
        return labelled_thickness(model);
    }
    const std::vector<double>& local = model.tissue.thickness;
    const double thickness = local.empty()
                                 ? options.tissue.thickness_mm
                                 : std::accumulate(local.begin(), local.end(), 0.0) / static_cast<double>(local.size());
    return thickness_at(options, thickness, options.time.start);
}

} // namespace corticle::prepare

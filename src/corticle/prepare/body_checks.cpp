// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/body_checks.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace corticle::prepare
{

namespace
{

// Brains of mammals: 60 mm³ (Etruscan shrew) to 9 l (sperm whale), with room on both sides.
constexpr double smallest_brain_mm3 = 20.0;
constexpr double largest_brain_mm3 = 2e7;

/// What to look at when a body has the wrong size.
std::string_view unit_hint(const GeometryOptions& geometry)
{
    if (geometry.shape != Shape::file)
    {
        return "";
    }
    return formats::is_volume(geometry.file) ? "; are the voxel sizes of the image right?"
                                             : "; is geometry.unit right?";
}

void require_white_matter(const PreparationOptions& options, const material::TissueFields& tissue)
{
    const double t = options.time.start;
    const double scale = model::cortex_size(options).scale(t);
    double thinnest = material::thickness_at(tissue, options.tissue, 0, t) / scale;
    double deepest = 0.0;
    for (std::size_t i = 0; i < tissue.depth.size(); ++i)
    {
        const double thickness = material::thickness_at(tissue, options.tissue, i, t) / scale;
        if (tissue.depth[i] > thickness)
        {
            return;
        }
        thinnest = std::min(thinnest, thickness);
        deepest = std::max(deepest, tissue.depth[i]);
    }
    throw InputError(fmt::format("the cortex of {:.4g} mm is thicker than the body (largest depth {:.4g} mm): got no "
                                 "white matter, expected a smaller thickness{}",
                                 thinnest, deepest, unit_hint(options.geometry)));
}

/// The thickness goes linearly with t: its smallest value is at the start or at the end.
void require_thickness(const PreparationOptions& options, std::span<const Vec3> places,
                       const material::TissueFields& tissue)
{
    const std::vector<double>& map = tissue.thickness;
    const auto thinnest = map.empty() ? 0 : static_cast<std::size_t>(std::ranges::min_element(map) - map.begin());
    for (const double t : {options.time.start, options.time.end})
    {
        const double thickness = material::thickness_at(tissue, options.tissue, thinnest, t);
        if (!(thickness > 0.0))
        {
            const Vec3& X = places[thinnest];
            throw InputError(fmt::format(
                "tissue.thickness_rate_mm = {:g}: the cortex near ({:.4g}, {:.4g}, {:.4g}) mm, {:.4g} mm thick at t = "
                "0{}, has {:.4g} mm at t = {:.4g}; expected more than 0 during the whole run",
                options.tissue.thickness_rate_mm, X.x, X.y, X.z,
                material::thickness_at(tissue, options.tissue, thinnest, 0.0),
                options.map.thickness_file.empty() ? "" : " by map.thickness_file " + options.map.thickness_file,
                thickness, t));
        }
    }
}

} // namespace

void require_cortex(const PreparationOptions& options, std::span<const Vec3> places,
                    const material::TissueFields& tissue)
{
    require_thickness(options, places, tissue);
    require_white_matter(options, tissue);
}

std::string size_warning(const PreparationOptions& options, const model::Model& model)
{
    const double volume = std::accumulate(model.cloud.volumes.begin(), model.cloud.volumes.end(), 0.0);
    if (options.geometry.shape != Shape::file || (volume >= smallest_brain_mm3 && volume <= largest_brain_mm3))
    {
        return {};
    }
    return fmt::format("the body of {:.3g} mm³ is far {} than any brain{}", volume,
                       volume < smallest_brain_mm3 ? "smaller" : "larger", unit_hint(options.geometry));
}

} // namespace corticle::prepare

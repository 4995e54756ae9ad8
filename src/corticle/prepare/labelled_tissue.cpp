// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/labelled_tissue.hpp"

#include "corticle/base/error.hpp"
#include "corticle/imaging/surface_from_labels.hpp"
#include "corticle/material/layer.hpp"
#include "corticle/prepare/body_source.hpp"
#include "corticle/prepare/growth_table.hpp"
#include "corticle/prepare/label_surface.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace corticle::prepare
{

namespace
{

constexpr double smoothing_mm = 0.5; ///< of distances to labels; keeps a plate of two voxels
constexpr double least_thickness_mm = 0.1;

/// theta of the smooth step with the boundary where the labels have it: y - H is minus the distance inside.
double labelled_theta(double inside, double thickness)
{
    return thickness < least_thickness_mm ? 0.0 : 1.0 / (1.0 + std::exp(-10.0 * inside / thickness));
}

/// theta of every point.
std::vector<double> labelled_layer(const material::TissueOptions& options, const material::TissueFields& tissue)
{
    if (options.layer == material::Layer::binary)
    {
        return material::sharp_layer(tissue.cortex_inside, tissue.volume,
                                     material::volume_inside(tissue.cortex_inside, tissue.volume));
    }
    std::vector<double> theta(tissue.cortex_inside.size());
    std::ranges::transform(tissue.cortex_inside, tissue.thickness, theta.begin(), labelled_theta);
    return theta;
}

/// Sums over the outer surface.
struct CortexBelow
{
    double area = 0.0;
    double cortex_area = 0.0;
    double volume = 0.0; ///< area times thickness
};

CortexBelow cortex_below_surface(const model::Model& model)
{
    const std::vector<double> areas = vertex_areas(model.surface.vertices, model.surface.triangles);
    CortexBelow sums;
    for (std::size_t v = 0; v < areas.size(); ++v)
    {
        const auto particle = static_cast<std::size_t>(model.cloud.surface_particles[v]);
        sums.area += areas[v];
        if (model.tissue.cortex_inside[particle] > 0.0)
        {
            sums.cortex_area += areas[v];
            sums.volume += areas[v] * model.tissue.thickness[particle];
        }
    }
    return sums;
}

} // namespace

imaging::TissueReader read_tissues(const PreparationOptions& options, std::vector<std::string>& notes)
{
    const GeometryOptions& geometry = options.geometry;
    try
    {
        imaging::TissueReader reader(read_body_labels(geometry), options.labels, geometry.mask.labels, smoothing_mm);
        if (!reader.note.empty())
        {
            notes.push_back(reader.note);
        }
        return reader;
    }
    catch (const InputError& error)
    {
        const std::string text = error.what();
        throw InputError(text.starts_with(geometry.file) ? text : fmt::format("{}: {}", geometry.file, text));
    }
}

TriangleMesh inner_surface(const PreparationOptions& options, std::vector<std::string>& notes)
{
    const GeometryOptions& geometry = options.geometry;
    imaging::LabelVolume image = read_body_labels(geometry);
    const auto holds = [](const std::vector<std::int64_t>& list, std::int32_t label)
    { return std::ranges::find(list, label) != list.end(); };
    imaging::MaskOptions mask = settled_mask(geometry, image);
    const std::vector<std::int64_t>& cortex = options.labels[static_cast<std::size_t>(material::TissueKind::cortex)];
    for (std::int32_t& label : image.labels)
    {
        const bool is_body = mask.labels.empty() || holds(mask.labels, label);
        label = is_body && !holds(cortex, label) ? label : 0;
    }
    mask.labels.clear();
    try
    {
        return imaging::surface_from_labels(image, mask).surface;
    }
    catch (const InputError& error)
    {
        notes.push_back(fmt::format("no inner surface of the cortex from the labels ({}): its area is taken below the "
                                    "outer surface",
                                    error.what()));
        return {};
    }
}

void set_labelled_tissue(const imaging::TissueReader& reader, std::span<const Vec3> places,
                         material::TissueFields& tissue)
{
    imaging::LabelledPoints points = reader.at(places);
    tissue.kind = std::move(points.tissue);
    tissue.cortex_inside = std::move(points.cortex_inside);
    tissue.thickness.resize(places.size());
    std::ranges::transform(tissue.depth, tissue.cortex_inside, tissue.thickness.begin(),
                           [](double depth, double inside) { return std::max(0.0, depth + inside); });
}

void complete_labelled_tissue(const PreparationOptions& options, material::TissueFields& tissue)
{
    if (has_labelled_cortex(options))
    {
        tissue.given_theta = labelled_layer(options.tissue, tissue);
    }
    const bool has_ratio = std::ranges::any_of(options.tissue.bulk_ratio, [](const auto& r) { return r.has_value(); });
    if (options.tissue.growth_source != material::GrowthSource::keys)
    {
        tissue.growth.emplace(growth_rows(options), options.time.clock, options.time.start_week.value(),
                              options.time.end_week.value());
    }
    if (tissue.kind.empty() && (tissue.growth || has_ratio))
    {
        tissue.kind.assign(tissue.depth.size(), material::TissueKind::white);
    }
}

double largest_labelled_thickness(const imaging::TissueReader& reader, std::span<const Vec3> vertices)
{
    constexpr double part = 0.95; // single places deeper, where the banks of a sulcus are one in the labels
    std::vector<double> thickness = reader.at(vertices).cortex_inside;
    std::erase_if(thickness, [](double inside) { return inside <= 0.0; });
    if (thickness.empty())
    {
        return 0.0;
    }
    const auto place =
        thickness.begin() + static_cast<std::ptrdiff_t>(part * static_cast<double>(thickness.size() - 1));
    std::ranges::nth_element(thickness, place);
    return *place;
}

double labelled_thickness(const model::Model& model)
{
    const CortexBelow sums = cortex_below_surface(model);
    return sums.cortex_area > 0.0 ? sums.volume / sums.cortex_area : 0.0;
}

TissueReport report_tissues(const model::Model& model)
{
    const material::TissueFields& tissue = model.fem ? model.fem->tissue : model.tissue;
    TissueReport report;
    report.volume_mm3 = material::tissue_volumes(tissue, tissue.given_theta);
    const CortexBelow sums = cortex_below_surface(model);
    report.cortex_area_share = sums.cortex_area / sums.area;
    report.thickness_mm = labelled_thickness(model);
    return report;
}

} // namespace corticle::prepare

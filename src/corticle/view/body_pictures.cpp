// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/body_pictures.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/view/pictures.hpp"
#include "corticle/view/run_pictures.hpp"

#include <algorithm>
#include <array>
#include <numeric>

namespace corticle::view
{

namespace
{

/// Share of the particles in each of the bins between two bounds; the outer bins also hold what lies beyond.
Curve histogram(std::string label, std::span<const double> values, double low, double high)
{
    constexpr std::size_t bins = 60;
    std::vector<double> share(bins, 0.0);
    for (const double value : values)
    {
        const double at = (value - low) / (high - low) * static_cast<double>(bins);
        share[static_cast<std::size_t>(std::clamp(at, 0.0, static_cast<double>(bins) - 0.5))] +=
            1.0 / static_cast<double>(values.size());
    }
    Curve curve{std::move(label), {}, {}};
    for (std::size_t k = 0; k < bins; ++k) // as steps
    {
        for (const std::size_t edge : {k, k + 1})
        {
            curve.x.push_back(low + (high - low) * static_cast<double>(edge) / static_cast<double>(bins));
            curve.y.push_back(share[k]);
        }
    }
    return curve;
}

void render_quality(const std::filesystem::path& png, const BodyQuality& quality)
{
    const double worst = *std::max_element(quality.condition_number.begin(), quality.condition_number.end());
    const std::array panels{
        Panel{"nearest particle [spacings]",
              "share of particles",
              {histogram("nearest particle", quality.nearest_distance, 0.0, 1.5)}},
        Panel{"volume over mean", "share of particles", {histogram("volume", quality.volume_over_mean, 0.0, 2.0)}},
        Panel{"condition of the shape",
              "share of particles",
              {histogram("condition", quality.condition_number, 1.0, std::max(2.0, worst))}},
    };
    render_plot(png, panels, "Quality of the cloud");
}

void measure_tets(const fem::TetElements& elements, BodyQuality& quality)
{
    for (const Tet& tet : elements.tets)
    {
        const double condition = 1.0 / mean_ratio(elements.X, tet);
        for (const std::int32_t a : tet)
        {
            quality.condition_number[a] = std::max(quality.condition_number[a], condition);
            for (const std::int32_t b : tet)
            {
                const double distance = norm(elements.X[b] - elements.X[a]) / elements.spacing;
                quality.nearest_distance[a] =
                    a == b ? quality.nearest_distance[a] : std::min(quality.nearest_distance[a], distance);
            }
        }
    }
}

void measure_pairs(const model::Model& model, BodyQuality& quality)
{
    const Cloud& cloud = model.cloud;
    const tlsph::PairBlocks& pairs = model.particles.pairs;
    parallel_for(std::ssize(cloud.positions),
                 [&](std::int64_t i)
                 {
                     double nearest = 1e300;
                     for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                     {
                         nearest = std::min(nearest,
                                            squared_norm(cloud.positions[i] - cloud.positions[pairs.neighbor(i, k)]));
                     }
                     quality.nearest_distance[i] = std::sqrt(nearest) / cloud.spacing;
                     quality.condition_number[i] = tlsph::condition_number(model.particles.correction[i]);
                 });
}

} // namespace

BodyQuality measure_body_quality(const model::Model& model)
{
    const std::vector<double>& volumes = model.cloud.volumes;
    const std::size_t count = volumes.size();
    const double mean = std::accumulate(volumes.begin(), volumes.end(), 0.0) / static_cast<double>(count);
    BodyQuality quality{std::vector<double>(count, 1e300), std::vector<double>(count), std::vector<double>(count)};
    for (std::size_t i = 0; i < count; ++i)
    {
        quality.volume_over_mean[i] = volumes[i] / mean;
    }
    if (model.fem)
    {
        measure_tets(model.fem->elements, quality);
    }
    else
    {
        measure_pairs(model, quality);
    }
    return quality;
}

double cortex_share(const model::Model& model, std::span<const double> theta)
{
    double cortex = 0.0;
    double total = 0.0;
    for (std::size_t i = 0; i < model.cloud.volumes.size(); ++i)
    {
        cortex += theta[i] * model.cloud.volumes[i];
        total += model.cloud.volumes[i];
    }
    return cortex / total;
}

void render_body(const std::filesystem::path& folder, const model::Model& model, std::span<const double> theta,
                 const BodyQuality& quality)
{
    const material::TissueFields& tissue = model.tissue;
    const std::vector<Mat3> rest(model.cloud.positions.size(), Mat3::identity());
    const auto [back, front] = std::minmax_element(model.surface.vertices.begin(), model.surface.vertices.end(),
                                                   [](const Vec3& a, const Vec3& b) { return a.y < b.y; });
    CutInput cut{.positions = model.cloud.positions,
                 .origins = model.cloud.positions,
                 .F = rest,
                 .theta = theta,
                 .scalar = quality.volume_over_mean,
                 .spacing = model.cloud.spacing,
                 .surface_points = model.surface.vertices,
                 .triangles = model.surface.triangles,
                 .axis = 1,
                 .coordinate = 0.5 * (back->y + front->y)};
    render_cut(folder / "cloud.png", cut, {"volume over mean", 0.0, 2.0}, "Cells of the particles");
    cut.scalar = tissue.depth;
    render_cut(folder / "layer.png", cut,
               {"depth [mm]", 0.0, *std::max_element(tissue.depth.begin(), tissue.depth.end())}, "Layer and depth");
    std::vector<double> rightward;
    for (const Vec3& n : tissue.normal)
    {
        rightward.push_back(n.x);
    }
    cut.scalar = rightward;
    render_cut(folder / "normals.png", cut, {"x of the normal", -1.0, 1.0, ColorMap::coolwarm},
               "Normals of the surface, carried inside");

    struct Map
    {
        const char* file;
        const char* label;
        std::span<const double> of_points; ///< empty: the body has no such map
    };
    std::vector<SurfacePicture> pictures;
    std::vector<std::vector<double>> values; // pictures refer to them
    for (const Map& map : {Map{"surface.png", "regional growth", tissue.regional_rate},
                           Map{"thickness.png", "cortical thickness [mm]", tissue.thickness},
                           Map{"growth_onset.png", "onset of growth, growth time", tissue.growth_onset},
                           Map{"growth_rate.png", "rate of growth", tissue.growth_rate}})
    {
        if (!map.of_points.empty())
        {
            values.push_back(surface_values(model.cloud, map.of_points));
            pictures.push_back(
                {folder / map.file, values.back(), robust_scale(map.label, values.back(), ColorMap::viridis)});
        }
    }
    render_surface(model.surface.vertices, model.surface.triangles, pictures, "Body at rest");
    render_quality(folder / "quality.png", quality);
}

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/prepare.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/cloud/fill.hpp"
#include "corticle/cloud/from_tets.hpp"
#include "corticle/geometry/tetrahedralize.hpp"
#include "corticle/imaging/orientation.hpp"
#include "corticle/material/imperfection.hpp"
#include "corticle/mechanics/boundary/support_term.hpp"
#include "corticle/prepare/body_checks.hpp"
#include "corticle/prepare/body_maps.hpp"
#include "corticle/prepare/body_source.hpp"
#include "corticle/prepare/body_thickness.hpp"
#include "corticle/prepare/fibres.hpp"
#include "corticle/prepare/labelled_tissue.hpp"
#include "corticle/prepare/patterning.hpp"
#include "corticle/prepare/skull_surface.hpp"
#include "corticle/prepare/thesis/ellipsoid.hpp"
#include "corticle/prepare/thesis_choices.hpp"
#include "corticle/prepare/tract_file.hpp"
#include "corticle/prepare/ventricle_surface.hpp"

#include <fmt/format.h>

#include <numbers>
#include <numeric>
#include <optional>

namespace corticle::prepare
{

namespace
{

/// Depth and normal of every place from the closest point of the surface, in a box from its face of the highest z.
void set_depth(const GeometryOptions& geometry, const geometry::SurfaceTree& tree, std::span<const Vec3> places,
               material::TissueFields& tissue)
{
    tissue.depth.resize(places.size());
    tissue.normal.resize(places.size());
    if (geometry.shape == Shape::box)
    {
        std::ranges::transform(places, tissue.depth.begin(),
                               [&](const Vec3& X) { return std::max(0.0, 0.5 * geometry.size_mm[2] - X.z); });
        std::ranges::fill(tissue.normal, Vec3{0.0, 0.0, 1.0});
        return;
    }
    parallel_for(std::ssize(places),
                 [&](std::int64_t i)
                 {
                     const geometry::SurfacePoint nearest = tree.closest(places[i]);
                     tissue.depth[i] = std::sqrt(nearest.squared_distance);
                     tissue.normal[i] = tree.interpolated_normal(nearest);
                 });
}

/// Where the material of each node is: with particles the centroids of their cells, of which F is too
/// (theory/tlsph.md); with elements, whose material is elsewhere, the nodes.
std::span<const Vec3> material_places(const model::Model& model)
{
    return model.fem ? model.cloud.positions : model.cloud.centroids;
}

BodyMaps set_maps(const MapOptions& options, const TriangleMesh& map_surface, std::span<const Vec3> places,
                  material::TissueFields& tissue)
{
    BodyMaps maps = read_body_maps(options, map_surface, places);
    tissue.mapped_rate = std::move(maps.growth);
    tissue.growth_maps.values = std::move(maps.growth_series);
    tissue.growth_onset = std::move(maps.onset);
    tissue.growth_rate = std::move(maps.rate);
    tissue.region = std::move(maps.region);
    tissue.thickness = std::move(maps.thickness);
    return maps;
}

/// Nodes of tets as particles; the tets themselves become elements where the method asks for them.
void take_nodes(const PreparationOptions& options, cloud::TetCloud nodes, Preparation& made)
{
    model::Model& model = made.model;
    model.cloud = std::move(nodes.cloud);
    model.surface = std::move(nodes.surface);
    made.report.remesh = nodes.remesh;
    if (options.method == model::Method::fem)
    {
        model.fem.emplace();
        model.fem->elements = fem::make_elements(
            model.cloud.positions, fem::ordered_tets(model.cloud.positions, nodes.tets), model.cloud.spacing);
        return;
    }
    std::ranges::move(nodes.warnings, std::back_inserter(made.report.warnings));
}

/// Triangles of a body, coarse ones of a shape.
TriangleMesh rough_surface(const PreparationOptions& options, const BodySource& source)
{
    constexpr double edges = 40.0; // about so many along a great circle
    return options.geometry.shape == Shape::file
               ? source.surface
               : shape_surface(options.geometry, 2.0 * std::numbers::pi * std::cbrt(source.volume / 4.2) / edges);
}

struct GradedResolution
{
    Resolution resolution;
    cloud::Grading grading;
};

/// @param tissues  of a labelled cortex; null: none is labelled
GradedResolution graded_resolution(const PreparationOptions& options, const BodySource& source,
                                   const imaging::TissueReader* tissues)
{
    if (options.geometry.grading <= 1.0)
    {
        return {resolve_resolution(options, source.volume, source.area), {}};
    }
    const TriangleMesh surface = rough_surface(options, source);
    const geometry::SurfaceTree tree(surface.vertices, surface.triangles);
    const cloud::DepthProfile profile(tree);
    const cloud::Grading grading =
        tissues != nullptr
            ? cloud::Grading{options.geometry.grading, largest_labelled_thickness(*tissues, surface.vertices)}
            : grading_of(options, source.map_surface, fitted_semi_axes(surface.vertices));
    return {resolve_resolution(options, source.volume, source.area, &profile, grading), grading};
}

/// The surface of a source at the resolution of the particles. Where that of labels would cross itself, a mask closed
/// and smoothed a little more is tried, so that the mask is no coarser than the spacing needs.
TriangleMesh remeshed_surface(const GeometryOptions& options, double edge_length, BodySource& source,
                              PreparationReport& report)
{
    constexpr int most_coarsening = 4;
    for (int coarsening = 1;; ++coarsening)
    {
        try
        {
            return geometry::remesh_isotropic(source.surface, edge_length, &report.remesh);
        }
        catch (const InputError& error)
        {
            if (!can_coarsen(options) || coarsening > most_coarsening)
            {
                throw;
            }
            report.notes.push_back(fmt::format("mask too fine for the spacing, made coarser: {}", error.what()));
        }
        source = read_body_source(options, coarsening);
    }
}

/// Surface and particles or tets of the options' arrangement; the surface's vertices are particles.
/// @param tissues  of a labelled cortex; null: none is labelled
/// @param source   receives a coarser mask where its surface asks for one
void set_cloud(const PreparationOptions& options, const imaging::TissueReader* tissues, BodySource& source,
               Preparation& made)
{
    model::Model& model = made.model;
    const GeometryOptions& geometry = options.geometry;
    const auto [resolution, grading] = graded_resolution(options, source, tissues);
    const auto [spacing, particles] = resolution;
    if (geometry.arrangement == Arrangement::body_fitted || geometry.arrangement == Arrangement::mesh_nodes)
    {
        model.surface = geometry.shape == Shape::file
                            ? remeshed_surface(options.geometry, cloud::edge_per_spacing * spacing, source, made.report)
                            : shape_surface(geometry, cloud::edge_per_spacing * spacing);
        if (options.method == model::Method::tlsph && geometry.arrangement == Arrangement::body_fitted)
        {
            model.cloud =
                cloud::fill_surface(model.surface, {spacing, static_cast<std::uint64_t>(geometry.seed), grading});
            return;
        }
        const geometry::RemeshReport remesh = made.report.remesh;
        take_nodes(options, cloud::cloud_from_tets(geometry::tetrahedralize(model.surface, particles)), made);
        made.report.remesh = remesh;
        return;
    }
    if (!source.tets)
    {
        throw InputError(fmt::format("geometry.arrangement = \"{}\": the nodes of a tet mesh become particles, but {} "
                                     "is none; expected a tet mesh, or arrangement = \"body_fitted\"",
                                     name_of(geometry.arrangement), geometry.file));
    }
    cloud::TetCloudOptions chosen;
    chosen.seed = static_cast<std::uint64_t>(geometry.seed);
    chosen.thinning = geometry.arrangement == Arrangement::thinned ? cloud::Thinning::uniform : cloud::Thinning::random;
    if (geometry.arrangement != Arrangement::tet_nodes)
    {
        chosen.particles = particles;
    }
    take_nodes(options, cloud::cloud_from_tets(*source.tets, chosen), made);
}

/// Regional growth as it is mapped, times the imperfection. @param thickness  of the cortex [mm]
void set_regional_rate(const PreparationOptions& options, double thickness, std::span<const Vec3> places,
                       material::TissueFields& tissue)
{
    tissue.regional_rate = tissue.mapped_rate;
    set_growth_times(options, tissue.growth_maps);
    apply_protomap(options.map, places, tissue);
    apply_modes(options.map.modes, places, tissue);
    const double amplitude = imperfection_amplitude(options);
    if (amplitude > 0.0)
    {
        const material::ImperfectionOptions& band = options.imperfection;
        const material::RandomWaves waves(static_cast<std::uint64_t>(band.seed), band.shortest * thickness,
                                          band.longest * thickness);
        material::apply_imperfection(waves, amplitude, places, tissue);
    }
}

/// What is left to know of the tissue: volumes, and the cortex where it does not follow from the depth.
void complete_tissue(const PreparationOptions& options, std::span<const Vec3> nodes, std::span<const Vec3> places,
                     std::vector<double> volumes, material::TissueFields& tissue)
{
    tissue.volume = std::move(volumes);
    complete_labelled_tissue(options, tissue);
    if (has_labelled_cortex(options))
    {
        return;
    }
    if (!has_layer_by_lambda(options))
    {
        require_cortex(options, places, tissue);
    }
    else
    {
        tissue.given_theta = layer_by_lambda(options, nodes, places, tissue.volume);
    }
}

/// How much stronger than solver.zeta the zero-energy control is (docs/decisions/zero-energy-control.md). A fine cloud
/// crumples where a free surface is compressed beyond Biot's strain, and one that resolves the cortex poorly is soft:
/// it folds early. @param spacings  through the cortex
double control_of(double spacings)
{
    constexpr double coarse = 3.0;
    constexpr double fine = 4.1;
    constexpr double most = 5.0;
    return std::min(std::pow(std::max(1.0, coarse / spacings), 2) * std::pow(std::max(1.0, spacings / fine), 4), most);
}

/// @param thickness  of the cortex [mm]
void connect_particles(const PreparationOptions& options, double thickness, Preparation& made)
{
    model::Model& model = made.model;
    const geometry::SurfaceTree tree(model.surface.vertices, model.surface.triangles);
    const double support = tlsph::support_mm(options.tlsph, model.cloud.spacing);
    const Neighbors pairs = options.tlsph.kernel_mm > 0.0
                                ? cloud::find_pairs_within(model.cloud.positions, support)
                                : cloud::find_neighbors(model.cloud, tree, support, &made.report.visibility);
    made.report.neighbors_mean =
        static_cast<double>(pairs.index.size()) / static_cast<double>(model.cloud.positions.size());
    tlsph::TlsphOptions method = options.tlsph;
    method.zeta *= control_of(thickness / model.cloud.spacing);
    model.particles = tlsph::make_particles(model.cloud, pairs, method);
}

} // namespace

cloud::Grading grading_of(const PreparationOptions& options, const TriangleMesh& map_surface,
                          const std::array<double, 3>& extents)
{
    if (options.geometry.grading <= 1.0)
    {
        return {};
    }
    if (has_layer_by_lambda(options))
    {
        return {options.geometry.grading,
                (1.0 - std::sqrt(options.tissue.lambda)) * *std::max_element(extents.begin(), extents.end())};
    }
    double thickness = options.tissue.thickness_mm;
    if (!options.map.thickness_file.empty())
    {
        MapOptions map;
        map.thickness_file = options.map.thickness_file;
        map.thickness_array = options.map.thickness_array;
        thickness = std::ranges::max(read_body_maps(map, map_surface, map_surface.vertices).thickness);
    }
    return {options.geometry.grading, std::max(thickness_at(options, thickness, options.time.start),
                                               thickness_at(options, thickness, options.time.end))};
}

Preparation arrange_body(const PreparationOptions& options)
{
    Preparation made;
    model::Model& model = made.model;
    BodySource source = read_body_source(options.geometry);
    std::optional<imaging::TissueReader> tissues;
    std::vector<std::string> tissue_notes;
    if (has_labelled_cortex(options))
    {
        tissues = read_tissues(options, tissue_notes);
    }
    set_cloud(options, tissues ? &*tissues : nullptr, source, made);
    made.report.source = source.kind;
    std::ranges::move(source.notes, std::back_inserter(made.report.notes));
    if (options.geometry.shape == Shape::file)
    {
        made.report.notes.push_back(imaging::describe_place(source.surface.vertices));
    }
    made.report.warnings = std::move(source.warnings);
    made.report.inputs = std::move(source.reports);
    made.report.input_vertices = std::ssize(source.surface.vertices);
    apply_thesis_volumes(options, model.cloud);
    const geometry::SurfaceTree tree(model.surface.vertices, model.surface.triangles);
    set_depth(options.geometry, tree, material_places(model), model.tissue);
    apply_thesis_normals(options, model);
    BodyMaps maps = set_maps(options.map, source.map_surface, material_places(model), model.tissue);
    std::ranges::move(maps.notes, std::back_inserter(made.report.notes));
    std::ranges::move(maps.warnings, std::back_inserter(made.report.warnings));
    std::vector<Vec3> places;
    if (model.fem)
    {
        places = fem::centroids(model.cloud.positions, model.fem->elements.tets);
        set_depth(options.geometry, tree, places, model.fem->tissue);
        set_maps(options.map, source.map_surface, places, model.fem->tissue);
    }
    std::ranges::move(tissue_notes, std::back_inserter(made.report.notes));
    if (tissues)
    {
        model.inner_surface = inner_surface(options, made.report.notes);
        set_labelled_tissue(*tissues, material_places(model), model.tissue);
        if (model.fem)
        {
            set_labelled_tissue(*tissues, places, model.fem->tissue);
        }
    }
    return made;
}

void connect_body(const PreparationOptions& options, Preparation& made)
{
    model::Model& model = made.model;
    const std::vector<Vec3>& X = model.cloud.positions;
    const double mean = mean_thickness(options, model);
    complete_tissue(options, X, material_places(model), model.cloud.volumes, model.tissue);
    set_regional_rate(options, mean, material_places(model), model.tissue);
    set_fibres(options, model.cloud, material_places(model), model.tissue);
    if (model.fem)
    {
        const fem::TetElements& elements = model.fem->elements;
        const std::vector<Vec3> places = fem::centroids(X, elements.tets);
        complete_tissue(options, X, places, elements.volume, model.fem->tissue);
        set_regional_rate(options, mean, places, model.fem->tissue);
        set_fibres(options, model.cloud, places, model.fem->tissue);
    }
    else
    {
        connect_particles(options, mean, made);
    }
    made.report.notes.push_back(fmt::format("largest depth {:.4g} mm below the surface, cortex {:.4g} mm thick",
                                            std::ranges::max(model.tissue.depth), mean));
    if (has_labelled_cortex(options))
    {
        made.report.inputs.tissues = report_tissues(model);
        made.report.notes.push_back(describe(*made.report.inputs.tissues));
    }
    model.skull = skull_surface(options, model);
    model.ventricles = ventricle_surface(options, model);
    model.tracts = read_tracts(options.tracts, model);
    boundary::held_degrees(model.cloud, options.supports); // refuses supports that hold nothing, or disagree
    if (const std::string warning = size_warning(options, model); !warning.empty())
    {
        made.report.warnings.push_back(warning);
    }
    const double thickness = least_thickness(options, model);
    if (thickness < 2.0 * model.cloud.spacing)
    {
        made.report.warnings.push_back(
            fmt::format("the cortex of {:.4g} mm is thinner than two spacings of {:.4g} mm and will fold at the wrong "
                        "wavelength; geometry.spacing_mm of at most {:.4g} is needed",
                        thickness, model.cloud.spacing, thickness / 2.0));
    }
}

Preparation prepare_body(const PreparationOptions& options)
{
    Preparation made = arrange_body(options);
    connect_body(options, made);
    return made;
}

} // namespace corticle::prepare

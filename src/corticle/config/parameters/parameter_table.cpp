// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/boundary_parameters.hpp"
#include "corticle/config/parameters/parameter_builders.hpp"
#include "corticle/config/parameters/remodelling_parameters.hpp"
#include "corticle/config/parameters/tissue_parameters.hpp"

#include <fmt/format.h>

namespace corticle::config
{

namespace
{

using namespace detail;

// The accessors: `[](auto& o) -> auto&` gives the member of an Options, const or not.
#define CORTICLE_MEMBER(path) ([](auto& options) -> auto& { return options.path; })

std::vector<Parameter> geometry_parameters()
{
    return {
        parameter("geometry.shape", "", {}, "Where the body comes from.", CORTICLE_MEMBER(geometry.shape)),
        parameter("geometry.radius_mm", "mm", above(0.0, 1000.0), "Radius of the sphere.",
                  CORTICLE_MEMBER(geometry.radius_mm)),
        parameter("geometry.semi_axes_mm", "mm", above(0.0, 1000.0), "Semi-axes of the ellipsoid.",
                  CORTICLE_MEMBER(geometry.semi_axes_mm)),
        parameter("geometry.size_mm", "mm", above(0.0, 1000.0),
                  "Lengths of the box along x, y and z; its cortex lies below its face of the highest z.",
                  CORTICLE_MEMBER(geometry.size_mm)),
        path("geometry.file",
             "Closed triangulated surface (STL, OBJ, PLY, OFF, VTP, GIFTI, FreeSurfer), label volume (NIfTI) or tet "
             "mesh (Gmsh, VTU, Netgen, Medit); needed by shape = \"file\".",
             CORTICLE_MEMBER(geometry.file)),
        parameter("geometry.unit", "", {}, "Unit of length of a surface or tet mesh.", CORTICLE_MEMBER(geometry.unit)),
        parameter("geometry.coordinates", "", {},
                  "Whether coordinates are brought to the scanner's where the file describes how (matrices of GIFTI, "
                  "volume geometry of FreeSurfer, xyzt_units of NIfTI), or taken as they are in the file.",
                  CORTICLE_MEMBER(geometry.coordinates)),
        parameter("geometry.repair", "", {},
                  "What is done with a surface that is open, self-intersecting, inside-out or in several shells: mend "
                  "it, wrap it, or refuse it.",
                  CORTICLE_MEMBER(geometry.repair)),
        parameter("geometry.wrap_alpha_mm", "mm", between(0.0, 1000.0),
                  "Radius of the ball that feels the surface in a wrap; 0: chosen from its size and holes.",
                  CORTICLE_MEMBER(geometry.wrap.alpha_mm)),
        parameter("geometry.wrap_offset_mm", "mm", between(0.0, 1000.0),
                  "Distance at which it does; 0: a twentieth of that radius.",
                  CORTICLE_MEMBER(geometry.wrap.offset_mm)),
        parameter("geometry.labels", "", between(-2147483648.0, 2147483647.0),
                  "Labels of a label volume that are the body; empty: all but 0, which must be the background.",
                  CORTICLE_MEMBER(geometry.mask.labels)),
        parameter("geometry.image_volume", "", at_least(0.0), "Which volume of a 4D image, counted from 0.",
                  CORTICLE_MEMBER(geometry.mask.volume)),
        with_example(parameter("geometry.threshold", "", between(-1e9, 1e9),
                               "Of a map of probabilities in place of labels: the body is where it is at least this; "
                               "not given: the image has labels.",
                               CORTICLE_MEMBER(geometry.mask.threshold)),
                     "0.5"),
        with_example(parameter("geometry.closing_mm", "mm", between(0.0, 20.0),
                               "Radius by which the mask of the labels is closed; not given: 0, or as little as the "
                               "spacing needs.",
                               CORTICLE_MEMBER(geometry.closing_mm)),
                     "1.8"),
        parameter("geometry.fill_cavities", "", {}, "Whether cavities of the mask are filled.",
                  CORTICLE_MEMBER(geometry.mask.fill_cavities)),
        with_example(parameter("geometry.smoothing_mm", "mm", between(0.0, 20.0),
                               "Standard deviation of the smoothing of the mask, which keeps its volume; not given: as "
                               "little as voxels and spacing need.",
                               CORTICLE_MEMBER(geometry.smoothing_mm)),
                     "1.2"),
        parameter("geometry.remove_handles", "", {}, "Whether the surface of the mask is made a topological sphere.",
                  CORTICLE_MEMBER(geometry.mask.remove_handles)),
        parameter("geometry.hemisphere", "", {}, "Which part of the mask is taken.",
                  CORTICLE_MEMBER(geometry.mask.hemisphere)),
        with_example(parameter("geometry.spacing_mm", "mm", above(0.0, 1000.0),
                               "Distance between neighbouring particles or nodes; instead of particles.",
                               CORTICLE_MEMBER(geometry.spacing_mm)),
                     "0.5"),
        parameter("geometry.particles", "",
                  between(static_cast<double>(prepare::fewest_particles), static_cast<double>(prepare::most_particles)),
                  "About this many particles or nodes; instead of spacing_mm.", CORTICLE_MEMBER(geometry.particles)),
        parameter("geometry.grading", "", between(1.0, 4.0),
                  "Spacing in the core over that in the cortex, which spacing_mm is.",
                  CORTICLE_MEMBER(geometry.grading)),
        parameter("geometry.seed", "", at_least(0.0), "Seed of the arrangement of particles.",
                  CORTICLE_MEMBER(geometry.seed)),
        parameter(
            "geometry.arrangement", "", {},
            "Particles: arranged to fit the body, the nodes of the tets that method = \"fem\" makes of it, or the "
            "nodes of a tet mesh from a file: all, thinned evenly, or thinned at random (thesis section 2.4.1).",
            CORTICLE_MEMBER(geometry.arrangement)),
        parameter("geometry.volumes", "", {},
                  "Volumes of the particles: exact, or by neighbour counts (thesis eqs. 25 and 26).",
                  CORTICLE_MEMBER(geometry.volumes)),
        parameter(
            "geometry.normals", "", {},
            "Normals of the particles: of the closest surface point, or of the nearest normal line (thesis section "
            "2.4.2).",
            CORTICLE_MEMBER(geometry.normals)),
        parameter("geometry.normal_divisions", "", between(1.0, 1000.0), "Divisions of each normal line.",
                  CORTICLE_MEMBER(geometry.normal_divisions)),
    };
}

bool has_protomap(const Options& options)
{
    return options.map.protomap_amplitude > 0.0;
}

std::vector<Parameter> map_parameters()
{
    return {
        path("map.growth_file",
             "Regional growth, a factor of alpha_t, at the vertices of the input surface: GIFTI, VTP, FreeSurfer curv "
             "or CSV.",
             CORTICLE_MEMBER(map.growth_file)),
        parameter("map.growth_array", "", {},
                  "Which array of that file; empty: its first. With growth_times: one for each, with commas.",
                  CORTICLE_MEMBER(map.growth_array)),
        parameter("map.growth_times", "t, or weeks with a clock", between(0.0, 100.0),
                  "Times of several arrays, increasing: relative rates of growth, interpolated in between; empty: one "
                  "array for all times.",
                  CORTICLE_MEMBER(map.growth_times)),
        path("map.thickness_file", "Cortical thickness at t = 0 [mm] at the vertices of the input surface.",
             CORTICLE_MEMBER(map.thickness_file)),
        parameter("map.thickness_array", "", {}, "Which array of that file; empty: its first.",
                  CORTICLE_MEMBER(map.thickness_array)),
        path("map.still_file",
             "Mask of what does not grow: not 0 there, at the vertices of the input surface or in a NIfTI volume.",
             CORTICLE_MEMBER(map.still_file)),
        parameter("map.still_array", "", {}, "Which array of that file; empty: its first.",
                  CORTICLE_MEMBER(map.still_array)),
        path("map.region_file",
             "Region labels, whole numbers at the vertices of the input surface or in a NIfTI volume.",
             CORTICLE_MEMBER(map.region_file)),
        parameter("map.region_array", "", {}, "Which array of that file; empty: its first.",
                  CORTICLE_MEMBER(map.region_array)),
        path("map.region_table",
             "CSV with columns label and growth, the factor of alpha_t in each region; with columns onset and rate "
             "these are by region too.",
             CORTICLE_MEMBER(map.region_table)),
        in_any_order(parameter("map.modes", "", between(-1.0, 1.0),
                               "Amplitudes of smooth modes of regional growth, at most 15: spherical harmonics of "
                               "degree 1 (y, z, x), 2 and 3 of the direction from the centre of the body.",
                               CORTICLE_MEMBER(map.modes))),
        parameter("map.protomap_amplitude", "", between(0.0, 2.0),
                  "Standard deviation of a smooth random map by which regional growth is multiplied, not below 0.",
                  CORTICLE_MEMBER(map.protomap_amplitude)),
        where(has_protomap, parameter("map.protomap_wavelength_mm", "mm", above(0.0, 1000.0), "Its wavelength.",
                                      CORTICLE_MEMBER(map.protomap_wavelength_mm))),
        where(has_protomap,
              parameter("map.protomap_seed", "", at_least(0.0), "Its seed.", CORTICLE_MEMBER(map.protomap_seed))),
    };
}

std::vector<Parameter> imperfection_parameters()
{
    return {
        with_default(
            parameter("imperfection.amplitude", "", between(0.0, 0.1),
                      "Standard deviation of the growth's relative deviation, a smooth random field that folds "
                      "grow from; not given: 0 for a body from a file, whose shape is imperfect enough, and for "
                      "the thesis's formulation.",
                      CORTICLE_MEMBER(imperfection.amplitude)),
            [](const Options& options) { return prepare::imperfection_amplitude(options); }),
        parameter("imperfection.seed", "", at_least(0.0), "Seed of that field.", CORTICLE_MEMBER(imperfection.seed)),
        parameter("imperfection.shortest", "thicknesses", between(1.0, 1000.0),
                  "Its shortest wavelength, in thicknesses of the cortex.", CORTICLE_MEMBER(imperfection.shortest)),
        parameter("imperfection.longest", "thicknesses", between(1.0, 1000.0), "Its longest wavelength.",
                  CORTICLE_MEMBER(imperfection.longest)),
    };
}

std::vector<Parameter> solver_parameters()
{
    return {
        parameter("solver.method", "", {}, "Discretisation: Total-Lagrangian SPH, or finite elements (linear tets).",
                  CORTICLE_MEMBER(method)),
        with_example(
            parameter(
                "solver.elements", "",
                between(static_cast<double>(fewest_elements), static_cast<double>(most_elements)),
                "About this many tets, or as many particles as they would have nodes; instead of geometry.particles or "
                "geometry.spacing_mm.",
                CORTICLE_MEMBER(elements)),
            "223000"),
        parameter("solver.formulation", "", {},
                  "Equations of motion: ours, or those the thesis prints, with which the keys that say how the thesis "
                  "does it take its values where they are not given.",
                  CORTICLE_MEMBER(formulation)),
        parameter("solver.support", "spacings", between(1.5, 5.0), "Support radius of the kernel.",
                  CORTICLE_MEMBER(tlsph.support)),
        parameter("solver.kernel_mm", "mm", between(0.0, 1000.0),
                  "Support radius of the kernel in mm, of pairs whatever lies between them; 0: solver.support.",
                  CORTICLE_MEMBER(tlsph.kernel_mm)),
        parameter("solver.zeta", "", between(0.0, 10.0),
                  "Strength of the control of zero-energy modes; more where fewer than 3 or more than 4.1 spacings go "
                  "through the cortex.",
                  CORTICLE_MEMBER(tlsph.zeta)),
        parameter("solver.integrator", "", {}, "Time integration; rk4 (Runge-Kutta) works without contact only.",
                  CORTICLE_MEMBER(dynamics.integrator)),
        parameter("solver.time_step", "t", between(0.0, 0.1), "Fixed time step; 0: as large as the state allows.",
                  CORTICLE_MEMBER(dynamics.time_step)),
        parameter("solver.cfl", "", above(0.0, 1.0), "Safety factor of the time step.", CORTICLE_MEMBER(dynamics.cfl)),
        parameter("solver.loading_time", "crossings", between(1.0, 100000.0),
                  "Time given to t = 0..1, in crossings of the body by a pressure wave.",
                  CORTICLE_MEMBER(dynamics.loading_time)),
        parameter(
            "solver.fastest_loading", "", between(1.0, 10.0),
            "Loading at most so many times faster, once folds have appeared and while they move slowly; 1: never.",
            CORTICLE_MEMBER(dynamics.fastest_loading)),
        parameter(
            "solver.slowest_loading", "", between(0.01, 1.0),
            "Loading so many times as fast while growth passes that at which a flat cortex folds, until folds have "
            "appeared; 1: never slower.",
            CORTICLE_MEMBER(dynamics.slowest_loading)),
        parameter("solver.damping", "", between(0.0, 100000.0), "Damping rate times the time given to t = 0..1.",
                  CORTICLE_MEMBER(dynamics.damping)),
        parameter("solver.max_halvings", "", between(0.0, 60.0),
                  "Consecutive halvings of the step before a run gives up.", CORTICLE_MEMBER(dynamics.max_halvings)),
    };
}

std::vector<Parameter> thesis_parameters()
{
    return {
        of_thesis(parameter("thesis.growth", "", {},
                            "Stress of F G, as printed, or of F G^-1 and pulled back (thesis eqs. 22 and 23).",
                            CORTICLE_MEMBER(thesis.growth))),
        of_thesis(parameter("thesis.force", "", {},
                            "Force from differences of stresses, as printed (thesis eq. 9), or from the energy.",
                            CORTICLE_MEMBER(thesis.force))),
        of_thesis(parameter(
            "thesis.gradient", "", {},
            "Gradient of the kernel: on positions, as printed (thesis eq. 10), on displacements, or corrected.",
            CORTICLE_MEMBER(thesis.gradient))),
        of_thesis(parameter("thesis.viscosity_alpha", "", between(0.0, 100.0),
                            "Linear artificial viscosity (thesis eq. 7).", CORTICLE_MEMBER(thesis.viscosity_alpha))),
        of_thesis(parameter("thesis.viscosity_beta", "", between(0.0, 100.0),
                            "Quadratic artificial viscosity (thesis eq. 7).", CORTICLE_MEMBER(thesis.viscosity_beta))),
    };
}

std::vector<Parameter> other_parameters()
{
    return {
        parameter("contact.enabled", "", {}, "Whether the surface is kept from passing through itself.",
                  CORTICLE_MEMBER(contact.enabled)),
        parameter("contact.distance", "spacings", above(0.0, 1.0), "Surfaces closer than this repel.",
                  CORTICLE_MEMBER(contact.distance)),
        parameter("contact.stiffness", "m (c_p/h)^2", above(0.0, 10.0),
                  "Stiffness of contact beside that of the tissue.", CORTICLE_MEMBER(contact.stiffness)),
        without_clock(parameter("time.start", "", between(0.0, 1.0), "Growth time t of the body as it is given.",
                                CORTICLE_MEMBER(time.start))),
        without_clock(parameter("time.end", "", above(0.0, 1.0), "Growth time t at which the run ends.",
                                CORTICLE_MEMBER(time.end))),
        parameter("time.clock", "", {}, "Clock between t and gestational weeks; with one the two keys below set t.",
                  CORTICLE_MEMBER(time.clock)),
        with_example(parameter("time.start_week", "weeks", between(0.0, 100.0),
                               "Gestational age of the body as it is given.", CORTICLE_MEMBER(time.start_week)),
                     "23.0"),
        with_example(parameter("time.end_week", "weeks", between(0.0, 100.0), "Gestational age at which the run ends.",
                               CORTICLE_MEMBER(time.end_week)),
                     "38.0"),
        parameter("size.law", "", {},
                  "Length of the brain by its week: 59/(1 - 0.55 t) mm, for the cubic clock, or a quadratic in weeks.",
                  CORTICLE_MEMBER(size.law)),
        parameter("size.applies_to", "", {},
                  "Whether the law scales the reference state or sets the length of the deformed body.",
                  CORTICLE_MEMBER(size.applies_to)),
        parameter("size.thin_cortex", "", {},
                  "Whether the cortex keeps its thickness in mm while the reference state is scaled, so that it thins "
                  "in the coordinates of the run.",
                  CORTICLE_MEMBER(size.thin_cortex)),
        parameter("size.scaled", "", {}, "Whether outputs are in mm at their week, or in those of the start.",
                  CORTICLE_MEMBER(size.scaled)),
        parameter("output.count", "", between(1.0, 100000.0), "Output times evenly spaced in t, besides t = 0.",
                  CORTICLE_MEMBER(output.count)),
        parameter("output.times", "", between(0.0, 1.0), "Output times instead of count, increasing; empty: count.",
                  CORTICLE_MEMBER(output.times)),
        parameter("output.weeks", "weeks", between(0.0, 100.0),
                  "Gestational weeks of outputs instead of count, increasing; needs a clock.",
                  CORTICLE_MEMBER(output.weeks)),
        parameter("output.pictures", "", {}, "Whether pictures are drawn.", CORTICLE_MEMBER(output.pictures)),
        parameter("output.picture_times", "", between(0.0, 1.0),
                  "Output times that get pictures (the nearest), increasing; empty: the last.",
                  CORTICLE_MEMBER(output.picture_times)),
        parameter("output.report", "", {}, "Whether report.html is written at the end of the run.",
                  CORTICLE_MEMBER(output.report)),
        parameter("output.checkpoint_minutes", "min", above(0.0, 100000.0), "Wall time between checkpoints.",
                  CORTICLE_MEMBER(output.checkpoint_minutes)),
    };
}

#undef CORTICLE_MEMBER

std::vector<Parameter> all_parameters()
{
    std::vector<Parameter> all;
    for (auto part : {geometry_parameters, map_parameters, tissue_parameters, growth_parameters, remodelling_parameters,
                      imperfection_parameters, solver_parameters, thesis_parameters, other_parameters,
                      boundary_parameters, tract_parameters, support_parameters})
    {
        std::ranges::move(part(), std::back_inserter(all));
    }
    return all;
}

} // namespace

std::span<const Parameter> parameters()
{
    static const std::vector<Parameter> all = all_parameters();
    return all;
}

Options default_options()
{
    Options options;
    options.geometry.particles = prepare::default_particles;
    return options;
}

} // namespace corticle::config

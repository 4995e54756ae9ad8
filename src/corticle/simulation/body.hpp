// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/neighbors.hpp"
#include "corticle/config/options.hpp"
#include "corticle/fem/elements.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/simulation/source_reports.hpp"
#include "corticle/tissue/tissue.hpp"
#include "corticle/tlsph/particles.hpp"

#include <optional>

namespace corticle
{

/// What preparation did and found.
struct PreparationReport
{
    std::string source;              ///< BodySource::kind
    std::vector<std::string> notes;  ///< what was found in the input and done to it, one line each
    SourceReports inputs;            ///< the same in numbers
    std::int64_t input_vertices = 0; ///< of the input surface; 0 for built-in shapes
    RemeshReport remesh;
    VisibilityReport visibility;
    double neighbors_mean = 0.0;
    std::vector<std::string> warnings; ///< one line each
};

/// The tets of a body, and the tissue at their centroids.
struct ElementBody
{
    TetElements elements;
    Tissue tissue;
};

/// Constant after preparation: nodes, surface, tissue at the material points, and what the method needs: pairs of
/// particles or elements.
struct Body
{
    Cloud cloud;                    ///< the nodes
    TriangleMesh surface;           ///< reference surface; its vertices are cloud.surface_particles
    Tissue tissue;                  ///< at the nodes
    Particles particles;            ///< pairs; empty with finite elements
    std::optional<ElementBody> fem; ///< of method "fem"
    PreparationReport report;
};

/// theta at the present time of growth, at the nodes and in the elements.
void set_layer(Body& body, double t);

/// Spacing and particle count the options ask for on a body of the given volume.
struct Resolution
{
    double spacing_mm;
    std::int64_t particles;
};
/// @throws InputError when it gives fewer than 500 or more than 100 million particles, or more than memory holds
Resolution resolve_resolution(const Options& options, double volume_mm3, double area_mm2);

/// Input, surface, cloud, tets, and what the tissue is where: all that depends on the keys of [geometry] and [map] and
/// on the method alone, and all that a body file holds. @throws InputError
Body arrange_body(const Options& options);

/// Layer, pairs and pair weights of an arranged body: all that also depends on the other keys. @throws InputError
void connect_body(const Options& options, Body& body);

/// From the options to a body ready to fold. @throws InputError
Body prepare_body(const Options& options);

/// Rough memory of a run [bytes], from the number of particles or nodes and neighbours each.
double estimated_memory(Method method, double particles, double neighbors);

} // namespace corticle

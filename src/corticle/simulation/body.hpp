// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/neighbors.hpp"
#include "corticle/config/options.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/simulation/source_reports.hpp"
#include "corticle/tissue/tissue.hpp"
#include "corticle/tlsph/particles.hpp"

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

/// Constant after preparation: nodes, surface, tissue at the material points, pairs.
struct Body
{
    Cloud cloud;
    TriangleMesh surface; ///< reference surface; its vertices are cloud.surface_particles
    Tissue tissue;
    Particles particles;
    PreparationReport report;
};

/// Spacing and particle count the options ask for on a body of the given volume.
struct Resolution
{
    double spacing_mm;
    std::int64_t particles;
};
/// @throws InputError when it gives fewer than 500 or more than 100 million particles, or more than memory holds
Resolution resolve_resolution(const Options& options, double volume_mm3);

/// Input, surface, cloud, and what the tissue is where: all that depends on the keys of [geometry] and [map] alone, and
/// all that a body file holds. @throws InputError
Body arrange_body(const Options& options);

/// Layer, pairs and pair weights of an arranged body: all that also depends on the other keys. @throws InputError
void connect_body(const Options& options, Body& body);

/// From the options to a body ready to fold. @throws InputError
Body prepare_body(const Options& options);

/// Rough memory of a run [bytes], from the number of particles and neighbours each.
double estimated_memory(double particles, double neighbors);

} // namespace corticle

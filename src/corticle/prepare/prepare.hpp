// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/depth_profile.hpp"
#include "corticle/cloud/neighbors.hpp"
#include "corticle/geometry/remesh.hpp"
#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"
#include "corticle/prepare/source_reports.hpp"

#include <string>
#include <vector>

namespace corticle::prepare
{

/// What preparation did and found.
struct PreparationReport
{
    std::string source;              ///< BodySource::kind
    std::vector<std::string> notes;  ///< what was found in the input and done to it, one line each
    SourceReports inputs;            ///< the same in numbers
    std::int64_t input_vertices = 0; ///< of the input surface; 0 for built-in shapes
    geometry::RemeshReport remesh;
    cloud::VisibilityReport visibility;
    double neighbors_mean = 0.0;
    std::vector<std::string> warnings; ///< one line each
};

/// A body and how it was made.
struct Preparation
{
    model::Model model;
    PreparationReport report;
};

/// Spacing and particle count the options ask for on a body of the given volume.
struct Resolution
{
    double spacing_mm;
    std::int64_t particles;
};
/// @param profile  of the body where the cloud is graded, null otherwise
/// @throws InputError when it gives fewer than 500 or more than 100 million particles, or more than memory holds
Resolution resolve_resolution(const PreparationOptions& options, double volume_mm3, double area_mm2,
                              const cloud::DepthProfile* profile = nullptr, const cloud::Grading& grading = {});

/// How the spacing grows with depth, where no labels say how thick the cortex is.
/// @param map_surface  whose vertices a map of the thickness refers to
/// @param extents      semi-axes of the body [mm]
cloud::Grading grading_of(const PreparationOptions& options, const TriangleMesh& map_surface,
                          const std::array<double, 3>& extents);

/// Input, surface, cloud, tets, and what the tissue is where: all that depends on the keys of [geometry] and [map] and
/// on the method alone, and all that a body file holds. @throws InputError
Preparation arrange_body(const PreparationOptions& options);

/// Layer, pairs and pair weights of an arranged body: all that also depends on the other keys. @throws InputError
void connect_body(const PreparationOptions& options, Preparation& made);

/// From the options to a body ready to fold. @throws InputError
Preparation prepare_body(const PreparationOptions& options);

/// Rough memory of a run [bytes], from the number of particles or nodes and neighbours each.
double estimated_memory(model::Method method, double particles, double neighbors);

} // namespace corticle::prepare

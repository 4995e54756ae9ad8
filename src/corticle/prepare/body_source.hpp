// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"
#include "corticle/prepare/options.hpp"
#include "corticle/prepare/source_reports.hpp"

#include <optional>
#include <string>
#include <vector>

namespace corticle::prepare
{

/// What a body is made from, before particles are arranged. [mm]
struct BodySource
{
    std::string kind;                  ///< "sphere" | "ellipsoid" | "surface" | "labels" | "tets"
    TriangleMesh surface;              ///< closed and valid; empty for a sphere or an ellipsoid
    TriangleMesh map_surface;          ///< as in the file: maps give numbers at its vertices; empty where there is none
    std::optional<TetMesh> tets;       ///< of a tet mesh
    double volume = 0.0;               ///< enclosed [mm³]
    double area = 0.0;                 ///< of the surface [mm²]
    std::vector<std::string> notes;    ///< what was found and done, one line each
    std::vector<std::string> warnings; ///< one line each
    SourceReports reports;             ///< the same in numbers
};

/// Reads and cleans the input the options name.
/// @param coarsening  0; more where a surface of labels turned out too fine for the spacing: each closes the mask by
/// half a spacing more and smooths it by a quarter more, unless the options say how
/// @throws InputError
BodySource read_body_source(const GeometryOptions& options, int coarsening = 0);

/// How the mask of labels is cleaned where the options do not say: at the resolution of the image, so that fissures
/// stay open.
imaging::MaskOptions settled_mask(const GeometryOptions& options, const imaging::LabelVolume& image,
                                  int coarsening = 0);

/// Whether another coarsening would make another surface.
bool can_coarsen(const GeometryOptions& options);

/// Semi-axes of a sphere or an ellipsoid [mm].
std::array<double, 3> semi_axes(const GeometryOptions& options);

} // namespace corticle::prepare

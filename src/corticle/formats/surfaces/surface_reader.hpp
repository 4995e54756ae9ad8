// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::formats
{

/// How a surface file is read.
struct SurfaceFileOptions
{
    double scale = 1.0; ///< of its coordinates, to millimetres
    Coordinates coordinates = Coordinates::scanner;
    std::vector<std::string>* notes = nullptr; ///< receives a line for each transformation that the file describes
};

/// Reads a triangulated surface: STL (ASCII and binary), OBJ, PLY (ASCII and binary), OFF, VTP, GIFTI and FreeSurfer's
/// binary triangles, which are recognised by their first bytes; polygons are fanned into triangles; coordinates are
/// multiplied by the scale. Vertices at the same position are merged. GIFTI and FreeSurfer surfaces come out in scanner
/// RAS where the file says how to get there and the options do not forbid it: GIFTI by the matrix that leads to
/// NIFTI_XFORM_SCANNER_ANAT, FreeSurfer's tkRAS by the volume geometry (cras and axes). Never crashes, hangs or
/// allocates more than the file can justify.
/// @throws InputError, one line naming the file, when it is missing, not of these formats, truncated, or holds
/// non-finite numbers or bad indices.
TriangleMesh read_surface(const std::filesystem::path& file, const SurfaceFileOptions& options = {});

/// The same with all vertices and triangles of the file, in its order: those that maps per vertex belong to.
TriangleMesh read_surface_unmerged(const std::filesystem::path& file, const SurfaceFileOptions& options = {});

/// read_surface from bytes already in memory; `extension` is lower case without the dot, `name` is used in messages.
/// (What the fuzz test drives.)
TriangleMesh parse_surface(std::string_view bytes, const std::string& extension, const std::string& name,
                           const SurfaceFileOptions& options = {});

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <filesystem>
#include <string>

namespace corticle::formats
{

/// Is this, by its extension, a file that read_tets reads: .msh, .mesh or .vtu?
bool is_tet_file(const std::filesystem::path& file);

/// Reads the tets of a volume mesh: Gmsh .msh 2 and 4 (ASCII and binary, either byte order), VTK .vtu, Netgen neutral
/// .mesh, Medit .mesh (ASCII). What kind a file is, its content says. Coordinates are multiplied by `scale`. Points,
/// lines and faces in the file are left out; tets of higher order give their corners. Nodes keep the order of the file,
/// used or not. `notes` receives a line for whatever was not taken as it stands. Never crashes, hangs or allocates more
/// than the file can justify.
/// @throws InputError, one line naming the file, when it is missing, not of these formats, truncated, holds other solid
/// cells than tets, non-finite numbers or tets of nodes that do not exist.
TetMesh read_tets(const std::filesystem::path& file, double scale = 1.0, std::vector<std::string>* notes = nullptr);

/// The same from bytes already in memory; `name` is used in messages. (What the fuzz test drives.)
TetMesh parse_tets(std::string_view bytes, const std::string& name, std::vector<std::string>* notes = nullptr);

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <filesystem>

namespace corticle
{

/// Writes a tet mesh as Gmsh .msh 4.1 (text, one volume); read_tets reads it back to the bit. The file appears whole or
/// not at all. @throws RunError when it cannot be written, naming the file.
void write_tets_msh(const std::filesystem::path& file, const TetMesh& mesh);

} // namespace corticle

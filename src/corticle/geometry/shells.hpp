// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/error.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <string>
#include <vector>

namespace corticle::geometry
{

/// Several bodies of comparable volume: which one is meant, only the user knows.
class SeveralShells : public InputError
{
  public:
    using InputError::InputError;
};

/// The pieces that hang together, as surfaces of their own; a vertex belongs to one piece at most.
std::vector<TriangleMesh> separate_shells(const TriangleMesh& surface);

/// Without open pieces of less than 1 % of the area; a line says so.
TriangleMesh drop_open_crumbs(const TriangleMesh& surface, std::vector<std::string>& lines);

/// The largest of the closed shells of a surface, turned outward. Shells inside it (cavities, inner surfaces) and loose
/// ones of less than 1 % of its volume are dropped; lines say so. `volumes` are those of all, largest first [mm³].
/// @throws SeveralShells, naming `file`, when another shell is larger than that
TriangleMesh outer_shell(const TriangleMesh& surface, const std::string& file, std::vector<double>& volumes,
                         std::vector<std::string>& lines);

} // namespace corticle::geometry

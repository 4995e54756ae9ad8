// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <string>

namespace corticle::geometry
{

/// What was found in a tet mesh and what was done about it.
struct TetReport
{
    std::int64_t merged_nodes = 0;   ///< at exactly the place of another
    std::int64_t repeated_tets = 0;  ///< with the nodes of another; dropped
    std::int64_t flat_tets = 0;      ///< of no volume; dropped
    std::int64_t flipped_tets = 0;   ///< left-handed; two of their nodes exchanged
    bool is_left_handed = false;     ///< all tets were: a convention of the file
    std::int64_t dropped_nodes = 0;  ///< of no tet
    std::int64_t sliver_tets = 0;    ///< of a mean ratio below 0.05; kept
    double smallest_mean_ratio = 1.; ///< of the tets kept
    std::vector<std::string> lines;  ///< one for each repair, and for slivers
};

/// Repairs what can be repaired without a doubt: nodes at exactly the same place are merged, tets named twice and flat
/// ones dropped, left-handed ones flipped, nodes of no tet dropped. The result is right-handed; its tets fill one
/// body without overlap; its boundary is a surface that require_valid_surface accepts. Nodes keep their order.
/// @throws InputError, one line that names `file`, for anything else: no tets, a node that is not finite or does not
/// exist, only flat tets or mostly slivers, tets that overlap, parts that share no face, an inner cavity, or a boundary
/// that is not manifold or crosses itself.
TetMesh require_valid_tets(TetMesh mesh, const std::string& file, TetReport* report = nullptr);

} // namespace corticle::geometry

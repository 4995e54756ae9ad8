// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/tet_mesh.hpp"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace corticle::formats
{

/// Collects a tet mesh while a file is read. Files name nodes by tags: any whole numbers.
class TetBuilder
{
  public:
    explicit TetBuilder(std::string file) : file_(std::move(file)) {}

    const std::string& file() const { return file_; }
    std::int64_t node_count() const { return std::ssize(positions_); }
    std::int64_t tet_count() const { return std::ssize(tets_); }

    /// Sizes announced by the file; at most what its bytes can hold.
    void reserve_nodes(std::size_t nodes);
    /// @throws InputError for a coordinate that is not finite.
    void add_node(std::int64_t tag, const Vec3& position);
    /// The first four nodes of a tet are its corners; more make it one of higher order.
    void add_tet(std::span<const std::int64_t> tags);
    /// @throws InputError for no tet, a tag given twice, or a tet whose tag names no node.
    TetMesh finish(std::vector<std::string>* notes);

  private:
    std::string file_;
    std::vector<std::int64_t> tags_;
    std::vector<Vec3> positions_;
    std::vector<std::array<std::int64_t, 4>> tets_;
    std::int64_t higher_order_ = 0;
};

// One parser for each format; each throws InputError for whatever is not its format.
void parse_gmsh(std::string_view bytes, TetBuilder& mesh);
void parse_netgen(std::string_view text, TetBuilder& mesh);
void parse_medit(std::string_view text, TetBuilder& mesh);
void parse_vtu(std::string_view bytes, TetBuilder& mesh);
void parse_legacy_vtk_tets(std::string_view bytes, TetBuilder& mesh);

/// A legacy VTK file may hold tets or a surface. @throws InputError for what is no such file
bool has_legacy_vtk_tets(std::string_view bytes, const std::string& name);

} // namespace corticle::formats

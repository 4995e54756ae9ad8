// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// Reads one number for each of `vertex_count` vertices of a surface, in the order of its file
/// (read_surface_unmerged): GIFTI func or shape, an array of a .vtp, a column of a .csv or .txt, and of FreeSurfer curv
/// files (recognised by their first bytes), .mgh and .mgz (also NIfTI) with one voxel a vertex, .annot (numbers of
/// structures, -1: none), .label (1 at its vertices, else 0) and .asc. Any of them may be gzip-compressed. `array`
/// names which (arrays of GIFTI and MGH also by their number from 0); empty is for a file with only one.
/// @throws InputError, one line naming the file, for a missing array (listing those there), another number of values
/// than vertices, a value that is not finite, or a damaged file.
std::vector<double> read_surface_map(const std::filesystem::path& file, const std::string& array,
                                     std::int64_t vertex_count);

/// The same from bytes already in memory; `extension` is lower case without the dot, `name` is used in messages.
std::vector<double> parse_surface_map(std::string_view bytes, const std::string& extension, const std::string& name,
                                      const std::string& array, std::int64_t vertex_count);

/// Does this image hold one voxel for each vertex of a surface, in rows of height 1, as FreeSurfer writes maps?
/// @throws InputError for a damaged one
bool is_vertex_image(const std::filesystem::path& file, std::int64_t vertex_count);

} // namespace corticle::formats

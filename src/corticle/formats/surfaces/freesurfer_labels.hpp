// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

// FreeSurfer's regions and text files of numbers at vertices.

namespace corticle::formats
{

/// Regions of an annotation (.annot): for each vertex the number of its structure in the colour table of the file, -1
/// where it has none (as nibabel's read_annot). @throws InputError for a damaged file, or one without a colour table
std::vector<double> parse_annotation(std::string_view bytes, const std::string& name);

/// 1 at the vertices that a .label lists, else 0. @throws InputError for a damaged file, and vertices that are not
/// there
std::vector<double> parse_freesurfer_label(std::string_view text, const std::string& name, std::int64_t vertex_count);

/// Numbers at vertices as text (.asc): vertex, x, y, z, value in each line. @throws InputError
std::vector<double> parse_freesurfer_text_scalars(std::string_view text, const std::string& name);

} // namespace corticle::formats

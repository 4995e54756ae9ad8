// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"
#include "corticle/imaging/options.hpp"

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace corticle::view
{

/// From where neuroimagers look at a brain. Frame: x to the right, y to the front, z up.
struct AnatomicalView
{
    std::string_view name; ///< "left-medial"
    Vec3 from;             ///< unit, towards who looks
    Vec3 up;               ///< unit
    int half;              ///< -1: of the left hemisphere alone, 1: of the right one, 0: of the whole body
    std::string_view words;
    std::string_view plain_words; ///< of a body whose sides have no names

    /// Direction to the right of the picture.
    Vec3 right() const { return cross(up, from); }
};

/// Lateral, medial, dorsal and ventral of each hemisphere, and the whole from six sides and obliquely.
std::span<const AnatomicalView> anatomical_views();

/// The views of these names. @throws InputError naming one that is not a view
std::vector<AnatomicalView> views_named(std::span<const std::string> names);

/// Those of each hemisphere that the body has, in the order of a page of four columns.
std::vector<AnatomicalView> usual_views(imaging::Hemisphere part);

/// What lies to the left and to the right of a view: {"A", "P"}, or {"+y", "−y"} where sides have no names.
std::array<std::string, 2> side_marks(const AnatomicalView& view, bool is_brain);

/// Which sides of the body of a run are known.
struct BodySides
{
    bool is_brain = false; ///< from a file: sides have names
    imaging::Hemisphere part = imaging::Hemisphere::both;
};

/// From the case in a run folder, of whatever version. Without one nothing is known.
BodySides body_sides(const std::filesystem::path& run_folder);

} // namespace corticle::view

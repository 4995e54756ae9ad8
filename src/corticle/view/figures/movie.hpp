// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/view/figures/shapes.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace corticle::view
{

inline constexpr double movie_frames_per_second = 24.0;

/// A movie of a run's surface: what is drawn, and how.
struct MovieInput
{
    std::string name;              ///< of its files: "sulcal_depth"
    std::span<const Shape> shapes; ///< output times, ascending
    std::size_t array = 0;         ///< number of the array that colours them
    ColorScale scale;
    FigureLook look;
    int frames = 0;
};

/// Names of its files: the PNGs, NAME_movie/0001.png and on, and NAME.mp4.
std::vector<std::string> movie_files(const std::string& name, int frames);

struct MovieOutcome
{
    std::vector<std::filesystem::path> files; ///< the folder of the PNGs, and the MP4 if there is one
    std::string note;                         ///< why there is no MP4; empty: there is one
};

/// Draws `frames` PNGs, evenly spread over the weeks, or over growth time without weeks, between output times
/// interpolated linearly; and an MP4 of them where ffmpeg is. An MP4 has no transparency: with it there are PNGs alone.
/// @throws RunError when nothing can be drawn, or ffmpeg fails
MovieOutcome render_movie(const std::filesystem::path& folder, const MovieInput& movie);

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/choices.hpp"
#include "corticle/view/color_map.hpp"
#include "corticle/view/figures/anatomy.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace corticle::view
{

enum class PlotFormat
{
    png,
    svg,
    pdf
};

inline constexpr int usual_figure_width = 2000; ///< 170 mm at 300 points an inch [px]
inline constexpr int usual_movie_frames = 96;   ///< 4 s

/// Pictures of a run for papers, as `corticle render` is asked for them.
struct FigureRequest
{
    std::filesystem::path run;               ///< run folder
    std::vector<std::string> views;          ///< names; empty: usual_views
    std::vector<std::string> arrays;         ///< of the surface files; empty: sulcal depth
    std::vector<double> range;               ///< of the colours, two numbers; empty: scalar_scale of the times drawn
    std::optional<ColorMap> map;             ///< none: that of the array
    std::vector<double> times;               ///< growth times; the nearest output times are drawn
    std::vector<double> weeks;               ///< gestational weeks; likewise
    std::optional<imaging::Hemisphere> part; ///< none: by the case
    int width = usual_figure_width;          ///< of the page [px]
    bool is_transparent = false;
    std::vector<PlotFormat> plots; ///< formats of the plots of the measures
    int movie_frames = 0;          ///< 0: no movie
    std::filesystem::path out;     ///< empty: RUN/figures
    bool overwrite = false;

    /// Whether anything but the usual pictures of a run was asked for.
    bool is_asked() const;
};

struct FigureOutcome
{
    std::vector<std::filesystem::path> files;
    std::vector<std::string> notes; ///< what else to know: which times are shown, why there is no video
};

/// Draws the surface of a run by each array at each time asked for (without any at the last one; with plots or a movie
/// alone none), the plots of its measures, and a movie: a series of PNGs from the first to the last output time, with
/// positions and values between output times interpolated linearly, and an MP4 where ffmpeg is.
/// @throws InputError for a view, an array, a range or a time that is not there, a folder that holds no run, or files
/// of earlier figures without `overwrite`; RunError when nothing can be drawn, or ffmpeg fails
FigureOutcome render_figures(const FigureRequest& request);

} // namespace corticle::view

namespace corticle::config
{

template <>
inline std::vector<std::string> names<view::PlotFormat>()
{
    return {"png", "svg", "pdf"};
}

} // namespace corticle::config

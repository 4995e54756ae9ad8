// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/movie.hpp"

#include "corticle/base/child_process.hpp"
#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include <unistd.h>

namespace corticle::view
{

namespace
{

namespace fs = std::filesystem;

std::string folder_of(const std::string& name)
{
    return name + "_movie";
}

std::string frame_of(int number)
{
    return fmt::format("{:04}.png", number);
}

/// Path of a program; empty where there is none.
std::string found_program(const std::string& name)
{
    const char* const path = std::getenv("PATH");
    std::istringstream folders(path == nullptr ? "" : path);
    for (std::string folder; std::getline(folders, folder, ':');)
    {
        const std::string file = (fs::path(folder) / name).string();
        if (!folder.empty() && ::access(file.c_str(), X_OK) == 0)
        {
            return file;
        }
    }
    return {};
}

/// The place of a shape on the axis that frames are spread over.
double place_of(const Shape& shape)
{
    return std::isnan(shape.week) ? shape.t : shape.week;
}

/// The shape at a place of the axis.
Shape shape_at(std::span<const Shape> shapes, double place)
{
    const auto later = std::ranges::lower_bound(shapes, place, {}, place_of);
    const auto b = static_cast<std::size_t>(std::min(later, shapes.end() - 1) - shapes.begin());
    if (b == 0)
    {
        return shapes.front();
    }
    const double from = place_of(shapes[b - 1]);
    return between(shapes[b - 1], shapes[b], std::clamp((place - from) / (place_of(shapes[b]) - from), 0.0, 1.0));
}

/// The last line that says something.
std::string last_line(const std::string& text)
{
    const std::size_t end = text.find_last_not_of("\n\r ");
    const std::size_t begin = end == std::string::npos ? end : text.find_last_of('\n', end);
    return end == std::string::npos ? "no message" : text.substr(begin + 1, end - begin);
}

/// ffmpeg takes a % in a path for the number of a frame.
std::string pattern_of(const fs::path& folder)
{
    std::string text;
    for (const char c : folder.string())
    {
        text += c == '%' ? "%%" : std::string(1, c);
    }
    return text + "/%04d.png";
}

void encode(const std::string& ffmpeg, const fs::path& frames, const fs::path& mp4)
{
    formats::write_atomically(mp4,
                              [&](const fs::path& temporary)
                              {
                                  const ProcessEnd end = run_program({ffmpeg,
                                                                      "-nostdin",
                                                                      "-hide_banner",
                                                                      "-loglevel",
                                                                      "error",
                                                                      "-y",
                                                                      "-framerate",
                                                                      fmt::format("{}", movie_frames_per_second),
                                                                      "-i",
                                                                      "file:" + pattern_of(frames),
                                                                      "-c:v",
                                                                      "libx264",
                                                                      "-crf",
                                                                      "18",
                                                                      "-pix_fmt",
                                                                      "yuv420p",
                                                                      "-movflags",
                                                                      "+faststart",
                                                                      "-f",
                                                                      "mp4",
                                                                      "file:" + temporary.string()},
                                                                     "");
                                  if (end.signal != 0 || end.status != 0)
                                  {
                                      throw RunError(fmt::format("{}: ffmpeg failed ({}); the frames lie in {}",
                                                                 mp4.string(), last_line(end.errors), frames.string()));
                                  }
                              });
}

} // namespace

std::vector<std::string> movie_files(const std::string& name, int frames)
{
    std::vector<std::string> files;
    for (int number = 1; number <= frames; ++number)
    {
        files.push_back(folder_of(name) + "/" + frame_of(number));
    }
    files.push_back(name + ".mp4");
    return files;
}

MovieOutcome render_movie(const fs::path& folder, const MovieInput& movie)
{
    const fs::path frames = folder / folder_of(movie.name);
    const double first = place_of(movie.shapes.front());
    const double last = place_of(movie.shapes.back());
    for (int k = 0; k < movie.frames; ++k)
    {
        const double share = movie.frames == 1 ? 1.0 : static_cast<double>(k) / (movie.frames - 1);
        render_shape(frames / frame_of(k + 1), shape_at(movie.shapes, first + share * (last - first)), movie.array,
                     movie.scale, movie.look);
    }
    MovieOutcome outcome{{frames}, {}};
    const std::string ffmpeg = found_program("ffmpeg");
    if (movie.look.is_transparent)
    {
        outcome.note = "no MP4 with --transparent: an MP4 has no transparency";
    }
    else if (ffmpeg.empty())
    {
        outcome.note = "no MP4: ffmpeg is not installed (apt-get install ffmpeg)";
    }
    else
    {
        encode(ffmpeg, frames, folder / (movie.name + ".mp4"));
        outcome.files.push_back(folder / (movie.name + ".mp4"));
    }
    return outcome;
}

} // namespace corticle::view

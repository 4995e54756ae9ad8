// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/body.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/gather.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/report/packed.hpp"
#include "corticle/report/thinning.hpp"
#include "corticle/view/drawn_boundary.hpp"
#include "corticle/view/figures/anatomy.hpp"
#include "corticle/view/robust_range.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace corticle::report
{

namespace
{

namespace fs = std::filesystem;

constexpr std::size_t fewest_frames = 6;
constexpr std::size_t fewest_vertices = 2000;
constexpr int coarse_step = 16; ///< leaves 4096 values between the least and the largest

/// Arrays of surface files that are not scalars to look at; curvedness and the like follow from what is shown.
const std::set<std::string, std::less<>> left_out{"id", "gaussian_curvature", "curvedness", "shape_index"};

BodyFrame take_frame(formats::SurfaceFile file, double t, double week)
{
    std::vector<Vec3> boundary = view::drawn_boundary(file);
    BodyFrame frame{t, week, std::move(file.mesh.vertices), std::move(boundary), {}};
    const std::size_t count = frame.points.size();
    for (auto& [name, values] : file.fields)
    {
        if (values.size() == count && !left_out.contains(name))
        {
            frame.scalars.emplace_back(name, std::move(values));
        }
    }
    return frame;
}

Body thinned(const Body& body, std::size_t vertices)
{
    const ThinSurface thin = thin_surface(body.triangles, body.frames.front().points.size(), vertices);
    Body result{body.name, body.is_brain, thin.triangles, {}, body.step};
    for (const BodyFrame& frame : body.frames)
    {
        BodyFrame& less = result.frames.emplace_back(BodyFrame{frame.t, frame.week, {}, {}, {}});
        less.points = gather<Vec3>(frame.points, thin.kept);
        less.boundary = frame.boundary.empty() ? frame.boundary : gather<Vec3>(frame.boundary, thin.kept);
        for (const auto& [key, values] : frame.scalars)
        {
            less.scalars.emplace_back(key, gather<double>(values, thin.kept));
        }
    }
    return result;
}

void keep_frames(Body& body, std::size_t count)
{
    std::vector<BodyFrame> kept;
    for (const std::size_t k : spread(body.frames.size(), count))
    {
        kept.push_back(std::move(body.frames[k]));
    }
    body.frames = std::move(kept);
}

Json frame_json(const BodyFrame& frame, int step, Blobs& blobs)
{
    Json json{{"t", frame.t}, {"week", frame.week}};
    json["points"] = pack_numbers(flattened(frame.points), 3, blobs);
    if (!frame.boundary.empty())
    {
        json["boundary"] = pack_numbers(flattened(frame.boundary), 3, blobs, step);
    }
    json["scalars"] = Json::object();
    for (const auto& [key, values] : frame.scalars)
    {
        json["scalars"][key] = pack_numbers(values, 1, blobs, step);
    }
    return json;
}

/// Range of each scalar over all frames: {"key": {"robust": [low, high], "full": [low, high]}}.
Json ranges_json(const Body& body)
{
    Json json = Json::object();
    for (const auto& [key, first] : body.frames.back().scalars)
    {
        std::vector<double> all;
        for (const BodyFrame& frame : body.frames)
        {
            for (const auto& [name, values] : frame.scalars)
            {
                if (name == key)
                {
                    all.insert(all.end(), values.begin(), values.end());
                }
            }
        }
        const view::Range robust = view::robust_range(all);
        const view::Range full = view::full_range(all);
        json[key] = {{"robust", {robust.low, robust.high}}, {"full", {full.low, full.high}}};
    }
    return json;
}

/// What the arrays take as base64 if nothing deflates.
std::size_t bytes_at_most(const Body& body)
{
    std::size_t numbers = 6 * body.triangles.size();
    for (const BodyFrame& frame : body.frames)
    {
        numbers += frame.points.size() * (3 + frame.scalars.size()) + 3 * frame.boundary.size();
    }
    return 2 * numbers * 4 / 3;
}

std::size_t packed_bytes(const Body& body)
{
    Blobs blobs;
    pack_body(body, blobs);
    return blobs.bytes();
}

} // namespace

Body read_body(const record::RunContents& run, std::span<const std::size_t> chosen, std::string name)
{
    Body body{std::move(name), view::body_sides(run.folder).is_brain, {}, {}, 1};
    for (const std::size_t k : chosen)
    {
        const record::FrameFiles& files = run.frames[k];
        formats::SurfaceFile file = formats::read_surface_vtp(files.surface);
        if (file.mesh.vertices.empty() || !std::all_of(file.mesh.vertices.begin(), file.mesh.vertices.end(), is_finite))
        {
            throw InputError(fmt::format("{}: not a surface with finite coordinates", files.surface.string()));
        }
        if (body.triangles.empty())
        {
            body.triangles = file.mesh.triangles;
        }
        else if (body.triangles != file.mesh.triangles)
        {
            throw InputError(
                fmt::format("{}: other triangles than at the output times before", files.surface.string()));
        }
        body.frames.push_back(take_frame(std::move(file), files.t, record::week_at(run.measures, files.t)));
    }
    return body;
}

Body read_body(const record::RunContents& run, std::string name)
{
    std::vector<std::size_t> all(run.frames.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return read_body(run, all, std::move(name));
}

Json pack_body(const Body& body, Blobs& blobs)
{
    std::vector<std::uint32_t> corners;
    for (const Triangle& triangle : body.triangles)
    {
        for (const std::int32_t v : triangle)
        {
            corners.push_back(static_cast<std::uint32_t>(v));
        }
    }
    Json json{{"name", body.name}, {"brain", body.is_brain}, {"vertices", body.frames.front().points.size()}};
    json["ranges"] = ranges_json(body);
    json["triangles"] = pack_indices(corners, blobs);
    json["frames"] = Json::array();
    for (const BodyFrame& frame : body.frames)
    {
        json["frames"].push_back(frame_json(frame, body.step, blobs));
    }
    return json;
}

Json pack_bodies(std::vector<Body> bodies, std::size_t most_bytes, Blobs& blobs, std::vector<std::string>& notes)
{
    Json json = Json::array();
    for (Body& body : bodies)
    {
        const std::size_t share = most_bytes / bodies.size();
        const std::size_t frames = body.frames.size();
        const std::size_t vertices = body.frames.front().points.size();
        std::size_t bytes = bytes_at_most(body) > share ? packed_bytes(body) : 0;
        if (bytes > share)
        {
            body.step = coarse_step;
            bytes = packed_bytes(body);
            notes.push_back(fmt::format("{}: to keep the page small, values at vertices are rounded to 1/{} of their "
                                        "range (--max-mb).",
                                        body.name, 65536 / coarse_step));
        }
        if (bytes > share && frames > fewest_frames)
        {
            keep_frames(body, std::max(fewest_frames, frames * share / bytes));
            bytes = packed_bytes(body);
        }
        if (bytes > share && vertices > fewest_vertices)
        {
            const double factor = 0.95 * static_cast<double>(share) / static_cast<double>(bytes);
            body = thinned(body,
                           std::max(fewest_vertices, static_cast<std::size_t>(factor * static_cast<double>(vertices))));
        }
        if (body.frames.size() < frames || body.frames.front().points.size() < vertices)
        {
            notes.push_back(fmt::format("{}: to keep the page small, the surface shows {} of {} output times and {} of "
                                        "{} vertices. The plots are of all output times (--max-mb).",
                                        body.name, body.frames.size(), frames, body.frames.front().points.size(),
                                        vertices));
        }
        json.push_back(pack_body(body, blobs));
    }
    return json;
}

} // namespace corticle::report

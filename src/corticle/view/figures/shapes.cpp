// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/figures/shapes.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/view/drawn_boundary.hpp"
#include "corticle/view/run_pictures.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace corticle::view
{

namespace
{

std::vector<double> array_of(const formats::SurfaceFile& surface, const std::string& name,
                             const std::filesystem::path& file)
{
    std::vector<std::string> known;
    for (const auto& [key, values] : surface.fields)
    {
        if (values.size() == surface.mesh.vertices.size())
        {
            if (key == name)
            {
                return values;
            }
            known.push_back(key);
        }
    }
    throw InputError(fmt::format("--array: {} holds no \"{}\" with one number a vertex; expected one of {}",
                                 file.string(), name, fmt::join(known, ", ")));
}

template <class Value>
std::vector<Value> blend(const std::vector<Value>& a, const std::vector<Value>& b, double share)
{
    std::vector<Value> result;
    result.reserve(a.size());
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        result.push_back((1.0 - share) * a[i] + share * b[i]);
    }
    return result;
}

} // namespace

std::vector<std::size_t> every_frame(const record::RunContents& run)
{
    std::vector<std::size_t> all(run.frames.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
}

std::vector<Shape> read_shapes(const record::RunContents& run, std::span<const std::size_t> frames,
                               std::span<const std::string> arrays)
{
    std::vector<Shape> shapes;
    for (const std::size_t k : frames)
    {
        const record::FrameFiles& files = run.frames[k];
        formats::SurfaceFile surface = formats::read_surface_vtp(files.surface);
        if (surface.mesh.vertices.empty() ||
            !std::all_of(surface.mesh.vertices.begin(), surface.mesh.vertices.end(), is_finite))
        {
            throw InputError(fmt::format("{}: not a surface with finite coordinates", files.surface.string()));
        }
        Shape& shape = shapes.emplace_back();
        shape.t = files.t;
        shape.week = record::week_at(run.measures, files.t);
        for (const std::string& name : arrays)
        {
            shape.scalars.push_back(array_of(surface, name, files.surface));
        }
        shape.boundary = drawn_boundary(surface);
        shape.points = std::move(surface.mesh.vertices);
        shape.triangles = std::move(surface.mesh.triangles);
        if (shape.triangles != shapes.front().triangles)
        {
            throw InputError(
                fmt::format("{}: other triangles than at the output times before", files.surface.string()));
        }
    }
    return shapes;
}

Shape between(const Shape& a, const Shape& b, double share)
{
    Shape shape{(1.0 - share) * a.t + share * b.t,
                (1.0 - share) * a.week + share * b.week,
                blend(a.points, b.points, share),
                a.triangles,
                {},
                {}};
    if (a.boundary.size() == b.boundary.size())
    {
        shape.boundary = blend(a.boundary, b.boundary, share);
    }
    for (std::size_t number = 0; number < a.scalars.size(); ++number)
    {
        shape.scalars.push_back(blend(a.scalars[number], b.scalars[number], share));
    }
    return shape;
}

FigureLook look_at(std::span<const AnatomicalView> views, const BodySides& sides, std::span<const Shape> shapes,
                   int width, bool is_transparent)
{
    std::vector<std::span<const Vec3>> points;
    for (const Shape& shape : shapes)
    {
        points.emplace_back(shape.points);
    }
    return {views, sides, figure_layout(views, sides, points, width), is_transparent};
}

void render_shape(const std::filesystem::path& png, const Shape& shape, std::size_t number, const ColorScale& scale,
                  const FigureLook& look)
{
    render_figure(png,
                  {.points = shape.points,
                   .triangles = shape.triangles,
                   .boundary = shape.boundary,
                   .scalar = shape.scalars[number],
                   .scale = scale,
                   .title = time_text(shape.t, shape.week),
                   .views = look.views,
                   .sides = look.sides},
                  look.layout, look.is_transparent);
}

} // namespace corticle::view

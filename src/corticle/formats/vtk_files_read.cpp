// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/checksum.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <limits>

namespace corticle::formats
{

namespace
{

using Fields = std::vector<std::pair<std::string, std::vector<double>>>;

/// A field that is the same everywhere shrinks about a thousand times.
constexpr std::size_t largest_growth = 4096;

const VtkXmlPiece& only_piece(const VtkXmlFile& file)
{
    if (file.pieces().size() != 1)
    {
        fail_reading(file.file(), "not a file of this program", fmt::format("{} pieces", file.pieces().size()), "one");
    }
    return file.pieces().front();
}

std::int64_t point_count(const VtkXmlFile& file)
{
    const std::int64_t count = only_piece(file).count("NumberOfPoints");
    if (count > std::numeric_limits<std::int32_t>::max())
    {
        fail_reading(file.file(), "too many points", fmt::format("{}", count), "at most 2147483647");
    }
    return count;
}

std::vector<Vec3> read_points(const VtkXmlFile& file)
{
    const std::int64_t count = point_count(file);
    std::vector<Vec3> points;
    if (count == 0)
    {
        return points;
    }
    const std::vector<double> values = file.doubles(file.required(only_piece(file), "Points", ""), 3 * count);
    points.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < values.size(); i += 3)
    {
        points.push_back({values[i], values[i + 1], values[i + 2]});
    }
    return points;
}

Fields read_fields(const VtkXmlFile& file)
{
    Fields fields;
    for (const VtkXmlArray& array : only_piece(file).arrays)
    {
        if (array.section == "PointData")
        {
            fields.emplace_back(array.name, file.doubles(array, array.components * point_count(file)));
        }
    }
    return fields;
}

std::vector<Triangle> read_triangles(const VtkXmlFile& file)
{
    const std::int64_t count = only_piece(file).count("NumberOfPolys");
    if (count > std::numeric_limits<std::int32_t>::max())
    {
        fail_reading(file.file(), "too many triangles", fmt::format("{}", count), "at most 2147483647");
    }
    std::vector<Triangle> triangles;
    if (count == 0)
    {
        return triangles;
    }
    const std::vector<std::int64_t> corners =
        file.integers(file.required(only_piece(file), "Polys", "connectivity"), 3 * count);
    const std::int64_t points = point_count(file);
    triangles.resize(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
        if (corners[i] < 0 || corners[i] >= points)
        {
            fail_reading(file.file(), fmt::format("triangle {} names no vertex", i / 3),
                         fmt::format("index {}", corners[i]), fmt::format("0 to {}", points - 1));
        }
        triangles[i / 3][i % 3] = static_cast<std::int32_t>(corners[i]);
    }
    return triangles;
}

} // namespace

SurfaceFile read_surface_vtp(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    const VtkXmlFile xml(bytes, "PolyData", file.string(), largest_growth);
    return {{read_points(xml), read_triangles(xml)}, read_fields(xml)};
}

ParticleFile read_particles_vtu(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    const VtkXmlFile xml(bytes, "UnstructuredGrid", file.string(), largest_growth);
    return {read_points(xml), read_fields(xml)};
}

std::vector<std::pair<double, std::string>> read_pvd(const std::filesystem::path& file)
{
    const std::string bytes = read_whole_file(file);
    require_checksum(bytes, file.string());
    std::vector<std::pair<double, std::string>> frames;
    XmlTag tag;
    bool is_collection = false;
    bool is_complete = false;
    for (std::size_t position = 0; next_tag(bytes, position, tag); position = tag.end)
    {
        is_collection = is_collection || (tag.name == "VTKFile" && tag.attribute("type") == "Collection");
        is_complete = is_complete || (tag.name == "VTKFile" && tag.closes);
        if (tag.name != "DataSet" || tag.closes)
        {
            continue;
        }
        double time = 0.0;
        if (!to_number(tag.attribute("timestep"), time) || tag.attribute("file").empty())
        {
            fail_reading(file.string(), "bad frame in a .pvd", bytes.substr(tag.begin, tag.end - tag.begin),
                         "timestep and file");
        }
        frames.emplace_back(time, unescape_xml(tag.attribute("file")));
    }
    if (!is_collection || !is_complete)
    {
        fail_reading(file.string(), "not a complete .pvd file",
                     is_collection ? "no </VTKFile>" : "no VTKFile of type Collection", "a ParaView collection");
    }
    return frames;
}

} // namespace corticle::formats

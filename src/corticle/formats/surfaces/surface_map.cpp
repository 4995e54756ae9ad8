// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/surfaces/surface_map.hpp"

#include "corticle/formats/format_error.hpp"
#include "corticle/formats/gifti.hpp"
#include "corticle/formats/plain_file.hpp"
#include "corticle/formats/surfaces/freesurfer.hpp"
#include "corticle/formats/surfaces/freesurfer_labels.hpp"
#include "corticle/formats/text_scan.hpp"
#include "corticle/formats/text_table.hpp"
#include "corticle/formats/volumes/volume_numbers.hpp"
#include "corticle/formats/vtk_xml.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace corticle::formats
{

namespace
{

/// What is asked of a file.
struct Request
{
    const std::string& name; ///< of the file
    const std::string& array;
    std::int64_t vertex_count;
};

[[noreturn]] void fail_length(const Request& request, std::int64_t got)
{
    fail_reading(request.name, "a map of the wrong length", fmt::format("{} values", got),
                 fmt::format("{}, one for each vertex of the surface", request.vertex_count));
}

/// Index of the array asked for among those there.
std::size_t chosen(const Request& request, const std::vector<std::string>& names)
{
    const auto found = std::ranges::find(names, request.array);
    if (request.array.empty() && names.size() == 1)
    {
        return 0;
    }
    if (!request.array.empty() && found != names.end())
    {
        return static_cast<std::size_t>(found - names.begin());
    }
    constexpr std::size_t most_listed = 20;
    const bool too_many = names.size() > most_listed;
    const std::vector<std::string> listed(
        names.begin(), names.begin() + static_cast<std::ptrdiff_t>(std::min(names.size(), most_listed)));
    fail_reading(request.name, request.array.empty() ? "which array is not said" : "no such array",
                 request.array.empty() ? fmt::format("{} arrays", names.size()) : request.array,
                 names.empty() ? "a file with a scalar for each vertex"
                               : fmt::format("one of {}{}", fmt::join(listed, ", "), too_many ? ", ..." : ""));
}

std::vector<double> from_gifti(std::string_view bytes, const Request& request)
{
    GiftiFile file = parse_gifti(bytes, request.name);
    std::erase_if(file.arrays,
                  [](const GiftiArray& array) {
                      return array.intent == "NIFTI_INTENT_POINTSET" || array.intent == "NIFTI_INTENT_TRIANGLE" ||
                             array.columns() != 1;
                  });
    std::vector<std::string> names;
    for (const GiftiArray& array : file.arrays)
    {
        const auto found = array.metadata.find("Name");
        const bool is_named = found != array.metadata.end() && !found->second.empty();
        names.push_back(is_named ? found->second : std::to_string(names.size()));
    }
    std::size_t number = 0;
    const bool by_number = std::ranges::find(names, request.array) == names.end() && to_number(request.array, number) &&
                           number < names.size();
    return std::move(file.arrays[by_number ? number : chosen(request, names)].values);
}

std::vector<double> from_vtp(std::string_view bytes, const Request& request)
{
    constexpr std::size_t largest_growth = 4096; // numbers that are all the same
    const VtkXmlFile file(bytes, "PolyData", request.name, largest_growth);
    if (file.pieces().size() != 1)
    {
        fail_reading(request.name, "a map in several pieces", fmt::format("{}", file.pieces().size()), "one piece");
    }
    const VtkXmlPiece& piece = file.pieces().front();
    std::vector<std::string> names;
    std::vector<const VtkXmlArray*> arrays;
    for (const VtkXmlArray& array : piece.arrays)
    {
        if (array.section == "PointData" && array.components == 1)
        {
            names.push_back(array.name);
            arrays.push_back(&array);
        }
    }
    const VtkXmlArray& array = *arrays[chosen(request, names)];
    if (piece.count("NumberOfPoints") != request.vertex_count)
    {
        fail_length(request, piece.count("NumberOfPoints"));
    }
    return file.doubles(array, request.vertex_count);
}

/// A table numbers its vertices in a column of this name; values are in the order of the rows, so the numbers must be
/// those of the rows, from 0 or from 1.
void require_vertex_order(const TextTable& table, std::size_t column)
{
    const auto number = [&](std::size_t row)
    {
        double value = 0.0;
        return to_number(table.rows[row].cells[column], value) ? value : std::numeric_limits<double>::quiet_NaN();
    };
    constexpr std::size_t header = 1;
    const double first = table.rows.size() > header ? number(header) : 0.0;
    for (std::size_t row = header; row < table.rows.size(); ++row)
    {
        const double expected = (first == 1.0 ? 1.0 : 0.0) + static_cast<double>(row - header);
        if (number(row) != expected)
        {
            fail_reading(table.name,
                         fmt::format("line {}: values are not in the order of the vertices", table.rows[row].line),
                         fmt::format("vertex {}", table.rows[row].cells[column]), fmt::format("vertex {}", expected));
        }
    }
}

std::vector<double> from_text(std::string_view bytes, const Request& request)
{
    const TextTable table = parse_text_table(bytes, request.name);
    if (table.rows.empty())
    {
        fail_reading(request.name, "no map in the file", "no line with a number", "a number for each vertex");
    }
    const std::vector<std::string>& first = table.rows.front().cells;
    double value = 0.0;
    const bool has_header =
        std::ranges::none_of(first, [&](const std::string& cell) { return to_number(cell, value); });
    std::vector<std::string> names;
    for (std::size_t k = 0; k < first.size(); ++k)
    {
        names.push_back(has_header ? first[k] : std::to_string(k));
    }
    const std::size_t column = chosen(request, names);
    const auto vertex = std::ranges::find(names, "vertex");
    if (vertex != names.end() && vertex - names.begin() != static_cast<std::ptrdiff_t>(column))
    {
        require_vertex_order(table, static_cast<std::size_t>(vertex - names.begin()));
    }
    std::vector<double> values;
    for (std::size_t row = has_header ? 1 : 0; row < table.rows.size(); ++row)
    {
        const std::string& cell = table.rows[row].cells[column];
        if (!to_number(cell, value))
        {
            fail_reading(request.name,
                         fmt::format("line {} lacks a number in column {}", table.rows[row].line, names[column]),
                         cell.empty() ? "nothing" : cell, "a number");
        }
        values.push_back(value);
    }
    return values;
}

/// One voxel a vertex, in one of the volumes.
std::vector<double> from_image(const VolumeBytes& bytes, const Request& request)
{
    VolumeNumbers numbers(bytes, request.name, Coordinates::scanner);
    const VolumeHeader& header = numbers.header();
    const auto voxels = static_cast<std::int64_t>(header.voxels());
    if (voxels != request.vertex_count)
    {
        fail_length(request, voxels);
    }
    std::int64_t volume = 0;
    const bool is_chosen = header.volumes == 1 && request.array.empty();
    if (!is_chosen && (!to_number(request.array, volume) || volume < 0 || volume >= header.volumes))
    {
        fail_reading(request.name, request.array.empty() ? "which array is not said" : "no such array",
                     request.array.empty() ? fmt::format("{} maps", header.volumes) : request.array,
                     fmt::format("0 to {}", header.volumes - 1));
    }
    std::vector<double> values;
    numbers.read(volume, 1,
                 [&](std::span<const double> piece, std::size_t)
                 { values.insert(values.end(), piece.begin(), piece.end()); });
    return values;
}

/// Refuses another number of values than vertices, and values that are not finite.
std::vector<double> checked(std::vector<double> values, const Request& request)
{
    if (std::ssize(values) != request.vertex_count)
    {
        fail_length(request, std::ssize(values));
    }
    const auto bad = std::ranges::find_if(values, [](double value) { return !std::isfinite(value); });
    if (bad != values.end())
    {
        fail_reading(request.name, fmt::format("the value of vertex {} is not finite", bad - values.begin()),
                     fmt::format("{}", *bad), "a number for each vertex");
    }
    return values;
}

} // namespace

std::vector<double> parse_surface_map(std::string_view bytes, const std::string& extension, const std::string& name,
                                      const std::string& array, std::int64_t vertex_count)
{
    const Request request{name, array, vertex_count};
    std::vector<double> values;
    if (extension == "gii")
    {
        values = from_gifti(bytes, request);
    }
    else if (extension == "vtp")
    {
        values = from_vtp(bytes, request);
    }
    else if (extension == "csv" || extension == "txt")
    {
        values = from_text(bytes, request);
    }
    else if (extension == "annot")
    {
        values = parse_annotation(bytes, name);
    }
    else if (extension == "label")
    {
        values = parse_freesurfer_label(bytes, name, vertex_count);
    }
    else if (extension == "asc")
    {
        values = parse_freesurfer_text_scalars(bytes, name);
    }
    else if (is_volume("a." + extension))
    {
        values = from_image({bytes, {}}, request);
    }
    else if (is_freesurfer_scalars(bytes))
    {
        values = parse_freesurfer_scalars(bytes, name);
    }
    else
    {
        fail_reading(name, "unknown kind of surface map", extension.empty() ? "no extension" : "." + extension,
                     ".gii, .vtp, .csv, .txt, .mgh, .mgz, .annot, .label, .asc or a FreeSurfer curv file");
    }
    return checked(std::move(values), request);
}

std::vector<double> read_surface_map(const std::filesystem::path& file, const std::string& array,
                                     std::int64_t vertex_count)
{
    const std::string name = file.string();
    if (is_volume(file))
    {
        const VolumeFile image(file);
        const Request request{name, array, vertex_count};
        return checked(from_image(image.bytes(), request), request);
    }
    const PlainFile plain = read_plain_file(file);
    return parse_surface_map(plain.bytes, plain.extension, name, array, vertex_count);
}

bool is_vertex_image(const std::filesystem::path& file, std::int64_t vertex_count)
{
    if (!is_volume(file) || vertex_count == 0)
    {
        return false;
    }
    const VolumeFile image(file);
    const VolumeHeader header = VolumeNumbers(image.bytes(), file.string(), Coordinates::scanner).header();
    return static_cast<std::int64_t>(header.voxels()) == vertex_count && header.size[1] == 1;
}

} // namespace corticle::formats

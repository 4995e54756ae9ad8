// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/gifti.hpp"

#include "corticle/formats/atomic_file.hpp"
#include "corticle/formats/encoding.hpp"
#include "corticle/formats/xml_tag.hpp"
#include "corticle/geometry/surface_faults.hpp"

#include <fmt/format.h>

#include <cassert>
#include <cstring>

namespace corticle::formats
{

namespace
{

using Entries = std::vector<std::pair<std::string, std::string>>;

std::string metadata_xml(const Entries& entries)
{
    std::string text = "<MetaData>\n";
    for (const auto& [key, value] : entries)
    {
        text += fmt::format("<MD><Name>{}</Name><Value>{}</Value></MD>\n", escape_xml(key), escape_xml(value));
    }
    return text + "</MetaData>\n";
}

/// Little endian, as every machine this runs on.
template <class Number>
std::string packed_numbers(const std::vector<Number>& numbers)
{
    return to_base64(pack_zlib({reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(Number)}));
}

/// @param inside XML between the opening tag and the data
std::string array_xml(const char* intent, const char* type, std::size_t rows, int columns, const std::string& inside,
                      const std::string& data)
{
    const std::string dimensions = columns == 1
                                       ? fmt::format("Dimensionality=\"1\" Dim0=\"{}\"", rows)
                                       : fmt::format("Dimensionality=\"2\" Dim0=\"{}\" Dim1=\"{}\"", rows, columns);
    return fmt::format("<DataArray Intent=\"{}\" DataType=\"{}\" ArrayIndexingOrder=\"RowMajorOrder\" {} "
                       "Encoding=\"GZipBase64Binary\" Endian=\"LittleEndian\" ExternalFileName=\"\" "
                       "ExternalFileOffset=\"\">\n{}<Data>{}</Data>\n</DataArray>\n",
                       intent, type, dimensions, inside, data);
}

std::string file_xml(std::size_t arrays, const Entries& metadata, const std::string& content)
{
    return fmt::format("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM "
                       "\"http://www.nitrc.org/frs/download.php/115/gifti.dtd\">\n<GIFTI Version=\"1.0\" "
                       "NumberOfDataArrays=\"{}\">\n{}<LabelTable/>\n{}</GIFTI>\n",
                       arrays, metadata_xml(metadata), content);
}

Entries structure_entry(const std::string& structure)
{
    return structure.empty() ? Entries{} : Entries{{"AnatomicalStructurePrimary", structure}};
}

/// A hemisphere that was cut out of a body is open.
std::string topology_of(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    const TriangleMesh surface{{points.begin(), points.end()}, {triangles.begin(), triangles.end()}};
    return geometry::find_edge_faults(surface).boundary_edges == 0 ? "Closed" : "Open";
}

constexpr const char* scanner_space = R"(<CoordinateSystemTransformMatrix>
<DataSpace>NIFTI_XFORM_SCANNER_ANAT</DataSpace>
<TransformedSpace>NIFTI_XFORM_SCANNER_ANAT</TransformedSpace>
<MatrixData>1 0 0 0
0 1 0 0
0 0 1 0
0 0 0 1</MatrixData>
</CoordinateSystemTransformMatrix>
)";

} // namespace

void write_surface_gifti(const std::filesystem::path& file, std::span<const Vec3> points,
                         std::span<const Triangle> triangles, const std::string& structure)
{
    std::vector<float> coordinates;
    coordinates.reserve(3 * points.size());
    for (const Vec3& p : points)
    {
        coordinates.insert(coordinates.end(),
                           {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    }
    std::vector<std::int32_t> corners;
    corners.reserve(3 * triangles.size());
    for (const Triangle& t : triangles)
    {
        corners.insert(corners.end(), t.begin(), t.end());
    }
    Entries about_points = structure_entry(structure);
    about_points.emplace_back("GeometricType", "Anatomical");
    const std::string content =
        array_xml("NIFTI_INTENT_POINTSET", "NIFTI_TYPE_FLOAT32", points.size(), 3,
                  metadata_xml(about_points) + scanner_space, packed_numbers(coordinates)) +
        array_xml("NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", triangles.size(), 3,
                  metadata_xml({{"TopologicalType", topology_of(points, triangles)}}), packed_numbers(corners));
    write_text_atomically(file, file_xml(2, structure_entry(structure), content));
}

void write_scalars_gifti(const std::filesystem::path& file, std::span<const Field> scalars,
                         const std::string& structure)
{
    std::string content;
    for (const Field& field : scalars)
    {
        assert(field.components == 1);
        const std::vector<float> values(field.values.begin(), field.values.end());
        content += array_xml("NIFTI_INTENT_SHAPE", "NIFTI_TYPE_FLOAT32", values.size(), 1,
                             metadata_xml({{"Name", field.name}}), packed_numbers(values));
    }
    write_text_atomically(file, file_xml(scalars.size(), structure_entry(structure), content));
}

} // namespace corticle::formats

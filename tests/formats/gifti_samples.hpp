// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/encoding.hpp"
#include "formats/surfaces/surface_samples.hpp"

namespace corticle
{

/// How a sample of GIFTI stores its numbers.
struct GiftiStyle
{
    std::string encoding = "ASCII"; ///< "Base64Binary", "GZipBase64Binary"
    bool big_endian = false;
    bool by_columns = false;
    std::string float_type = "NIFTI_TYPE_FLOAT32"; ///< or "NIFTI_TYPE_FLOAT64"
};

/// One DataArray of `columns` numbers a row.
inline std::string gifti_array(const GiftiStyle& style, const std::string& intent, const std::string& type,
                               const std::vector<double>& by_rows, std::size_t columns, const std::string& inside = "")
{
    const std::size_t rows = by_rows.size() / columns;
    std::string text;
    std::string bytes;
    for (std::size_t i = 0; i < by_rows.size(); ++i)
    {
        const double value = by_rows[style.by_columns ? i % rows * columns + i / rows : i];
        text += std::to_string(value) + " ";
        if (type == "NIFTI_TYPE_INT32")
        {
            append(bytes, static_cast<std::int32_t>(value), style.big_endian);
        }
        else if (type == "NIFTI_TYPE_FLOAT32")
        {
            append(bytes, static_cast<float>(value), style.big_endian);
        }
        else
        {
            append(bytes, value, style.big_endian);
        }
    }
    const std::string data = style.encoding == "ASCII"          ? text
                             : style.encoding == "Base64Binary" ? formats::to_base64(bytes)
                                                                : formats::to_base64(formats::pack_zlib(bytes));
    return "<DataArray Intent=\"" + intent + "\" DataType=\"" + type + "\" ArrayIndexingOrder=\"" +
           (style.by_columns ? "ColumnMajorOrder" : "RowMajorOrder") + "\" Dimensionality=\"" +
           (columns == 1 ? "1" : "2") + "\" Dim0=\"" + std::to_string(rows) + "\"" +
           (columns == 1 ? "" : " Dim1=\"" + std::to_string(columns) + "\"") + " Encoding=\"" + style.encoding +
           "\" Endian=\"" + (style.big_endian ? "BigEndian" : "LittleEndian") +
           "\" ExternalFileName=\"\" ExternalFileOffset=\"0\">\n" + inside + "<Data>" + data +
           "</Data>\n</DataArray>\n";
}

inline std::string gifti_file(const std::string& arrays)
{
    return "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n<GIFTI Version=\"1.0\" "
           "NumberOfDataArrays=\"2\">\n<MetaData><MD><Name><![CDATA[a < b]]></Name><Value>1</Value></MD></MetaData>\n"
           "<LabelTable/>\n" +
           arrays + "</GIFTI>\n";
}

inline std::string gifti_metadata(const std::vector<std::pair<std::string, std::string>>& entries)
{
    std::string text = "<MetaData>\n";
    for (const auto& [key, value] : entries)
    {
        text += "<MD><Name><![CDATA[" + key + "]]></Name>\n<Value><![CDATA[" + value + "]]></Value></MD>\n";
    }
    return text + "</MetaData>\n";
}

/// @param about_points XML within the array of points
inline std::string gifti_surface(const TriangleMesh& mesh, const GiftiStyle& style,
                                 const std::string& about_points = "")
{
    std::vector<double> points;
    std::vector<double> corners;
    for (const Vec3& v : mesh.vertices)
    {
        points.insert(points.end(), {v.x, v.y, v.z});
    }
    for (const Triangle& t : mesh.triangles)
    {
        corners.insert(corners.end(), t.begin(), t.end());
    }
    return gifti_file(gifti_array(style, "NIFTI_INTENT_POINTSET", style.float_type, points, 3, about_points) +
                      gifti_array(style, "NIFTI_INTENT_TRIANGLE", "NIFTI_TYPE_INT32", corners, 3));
}

/// Two scalars per vertex, "depth" and one without a name.
inline std::string gifti_scalars(const GiftiStyle& style, const std::vector<double>& values)
{
    return gifti_file(
        gifti_array(style, "NIFTI_INTENT_SHAPE", style.float_type, values, 1, gifti_metadata({{"Name", "depth"}})) +
        gifti_array(style, "NIFTI_INTENT_NONE", style.float_type, values, 1));
}

/// A FreeSurfer triangle surface; `tags` stand behind its triangles.
inline std::string freesurfer_surface(const TriangleMesh& mesh, const std::string& tags = "")
{
    std::string bytes = "\xff\xff\xfe"
                        "created by a test\n\n";
    append(bytes, static_cast<std::int32_t>(mesh.vertices.size()), true);
    append(bytes, static_cast<std::int32_t>(mesh.triangles.size()), true);
    for (const Vec3& v : mesh.vertices)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            append(bytes, static_cast<float>(v[axis]), true);
        }
    }
    for (const Triangle& t : mesh.triangles)
    {
        for (const std::int32_t corner : t)
        {
            append(bytes, corner, true);
        }
    }
    return bytes + tags;
}

/// The tag that says where the volume behind a FreeSurfer surface lies.
inline std::string volume_geometry(const std::string& valid, const std::string& axes, const std::string& centre)
{
    std::string bytes;
    append(bytes, std::int32_t{20}, true);
    return bytes + "valid = " + valid + "  # volume info valid\nfilename = T1.mgz\nvolume = 256 256 256\n" +
           "voxelsize = 1 1 1\n" + axes + "cras   = " + centre + "\n";
}

inline std::string conformed_axes()
{
    return "xras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\n";
}

/// Scalars per vertex in FreeSurfer's new curv format.
inline std::string freesurfer_scalars(const std::vector<double>& values)
{
    std::string bytes = "\xff\xff\xff";
    append(bytes, static_cast<std::int32_t>(values.size()), true);
    append(bytes, std::int32_t{4}, true);
    append(bytes, std::int32_t{1}, true);
    for (const double value : values)
    {
        append(bytes, static_cast<float>(value), true);
    }
    return bytes;
}

} // namespace corticle

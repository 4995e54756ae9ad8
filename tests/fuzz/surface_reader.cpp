// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds damaged surface files to the reader. Usage: surface_reader [seconds].
#include "corticle/formats/surfaces/surface_reader.hpp"

#include "corticle/formats/vtk_files.hpp"
#include "formats/gifti_samples.hpp"
#include "formats/legacy_vtk_samples.hpp"
#include "formats/surfaces/freesurfer_samples.hpp"
#include "fuzz/reader_fuzz.hpp"

namespace corticle
{

namespace
{

std::vector<Sample> samples()
{
    const TriangleMesh mesh = tetrahedron();
    std::vector<Sample> result = surface_samples(mesh);
    const TemporaryFolder folder;
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles, {});
    const std::string vtp = bytes_of(folder / "a.vtp");
    result.emplace_back("vtp", vtp.substr(0, vtp.rfind("<!-- checksum"))); // which would refuse all damage
    for (const LegacyVtkStyle& style : legacy_vtk_styles())
    {
        result.emplace_back("vtk", legacy_vtk_surface(mesh, style));
    }
    result.emplace_back("asc", freesurfer_text_surface(mesh));
    const std::string metadata = gifti_metadata({{"VolGeomC_R", "1"}, {"VolGeomC_A", "2"}, {"VolGeomC_S", "3"}});
    result.emplace_back("gii", gifti_surface(mesh, {}, metadata));
    result.emplace_back("gii", gifti_surface(mesh, {"Base64Binary", true, true}));
    result.emplace_back("gii", gifti_surface(mesh, {"GZipBase64Binary"}));
    result.emplace_back("white", freesurfer_surface(mesh, volume_geometry("1", conformed_axes(), "5 -6 7.5")));
    return result;
}

} // namespace

} // namespace corticle

int main(int argc, char** argv)
{
    using namespace corticle;
    limit_memory();
    return fuzz_reader(argc > 1 ? std::atof(argv[1]) : 10.0, samples(),
                       {"\"", "<", "/>", "<!--", "solid", "end_header\n", "vertex", "=", "POINTS", "POLYGONS",
                        "99999999999", "OFFSETS", "METADATA"},
                       [](const std::string& kind, const std::string& bytes)
                       { formats::parse_surface(bytes, kind, "fuzz." + kind); });
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds damaged maps on surfaces to the reader. Usage: surface_map [seconds].
#include "corticle/formats/surfaces/surface_map.hpp"

#include "corticle/formats/vtk_files.hpp"
#include "formats/gifti_samples.hpp"
#include "formats/surfaces/freesurfer_samples.hpp"
#include "formats/volumes/mgh_samples.hpp"
#include "fuzz/reader_fuzz.hpp"

namespace corticle
{

namespace
{

std::vector<Sample> samples()
{
    const TriangleMesh mesh = tetrahedron();
    const std::vector<double> values{0.5, -1.25, 3.0, 8.0};
    const TemporaryFolder folder;
    formats::write_surface_vtp(folder / "a.vtp", mesh.vertices, mesh.triangles,
                               std::vector<formats::Field>{{"depth", 1, values}, {"m", 1, values}});
    const std::string vtp = bytes_of(folder / "a.vtp");
    MghSample image;
    image.size = {4, 1, 1, 1};
    return {{"vtp", vtp.substr(0, vtp.rfind("<!-- checksum"))}, // which would refuse all damage
            {"annot", annotation({1, 2, 3, 1}, {{5, "a", {1, 0, 0}}, {7, "b", {2, 0, 0}}})},
            {"annot", annotation({1, 2, 3, 1}, {{0, "a", {1, 0, 0}}, {1, "b", {2, 0, 0}}}, false)},
            {"label", "#!ascii label\n2\n3 1 2 3 0.5\n1 -1 -2 -3 0\n"},
            {"asc", "000 1 2 3 0.5\n001 1 2 3 -1\n002 1 2 3 2\n003 1 2 3 4\n"},
            {"mgh", image.numbers<float>(3, values).bytes()},
            {"gii", gifti_scalars({}, values)},
            {"gii", gifti_scalars({"Base64Binary", true}, values)},
            {"gii", gifti_scalars({"GZipBase64Binary"}, values)},
            {"thickness", freesurfer_scalars(values)},
            {"txt", "# m\n0.5\n-1.25\n3\n8\n"},
            {"csv", "id,\"depth\", x\n1,0.5,1\n2,-1.25,1\n3,3,1\n4,8,1\n"},
            {"csv", "vertex;depth\n0;0,5\n1;-1,25\n2;3\n3;8\n"}};
}

} // namespace

} // namespace corticle

int main(int argc, char** argv)
{
    using namespace corticle;
    limit_memory();
    return fuzz_reader(argc > 1 ? std::atof(argv[1]) : 10.0, samples(),
                       {"\"", "<", "/>", "<!--", ",", ";", "#", "depth"},
                       [](const std::string& kind, const std::string& bytes)
                       {
                           const bool has_names = kind == "vtp" || kind == "gii" || kind == "csv";
                           formats::parse_surface_map(bytes, kind, "fuzz." + kind, has_names ? "depth" : "", 4);
                       });
}

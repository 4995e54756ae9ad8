// SPDX-License-Identifier: GPL-3.0-or-later
// Feeds damaged tet meshes to the reader, and what it accepts to the repair. Usage: tet_reader [seconds].
#include "corticle/formats/tets/tet_reader.hpp"

#include "corticle/geometry/validate_tets.hpp"
#include "formats/legacy_vtk_samples.hpp"
#include "formats/tets/tet_samples.hpp"
#include "formats/tets/tet_writers.hpp"
#include "fuzz/reader_fuzz.hpp"
#include "geometry/simple_tets.hpp"

namespace corticle
{

namespace
{

std::vector<Sample> samples()
{
    const TetMesh mesh = two_tets();
    std::vector<Sample> result = tet_samples(mesh);
    for (Sample& sample : tet_samples(test::tet_box(2, {0, 0, 0}, {1, 1, 1})))
    {
        result.push_back(std::move(sample));
    }
    const TemporaryFolder folder;
    write_tets_vtu(folder / "a.vtu", mesh);
    result.emplace_back("vtu", bytes_of(folder / "a.vtu"));
    for (const LegacyVtkStyle& style : legacy_vtk_styles())
    {
        result.emplace_back("vtk", legacy_vtk_tets(mesh, style));
    }
    return result;
}

} // namespace

} // namespace corticle

int main(int argc, char** argv)
{
    using namespace corticle;
    limit_memory();
    return fuzz_reader(argc > 1 ? std::atof(argv[1]) : 10.0, samples(),
                       {"\"", "<", "/>", "<!--", "$", "$EndNodes\n", "$Nodes\n", "$Elements\n", "4.1 1 8", "2.2 1 8",
                        "Tetrahedra\n", "Vertices\n", "End", "#", "CELLS", "CELL_TYPES", "99999999999"},
                       [](const std::string& kind, const std::string& bytes)
                       { geometry::require_valid_tets(formats::parse_tets(bytes, "fuzz " + kind), "fuzz " + kind); });
}

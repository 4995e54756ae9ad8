// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/tets/gmsh_writer.hpp"

#include "corticle/formats/atomic_file.hpp"

#include <fmt/format.h>

#include <iterator>
#include <string>

namespace corticle
{

void write_tets_msh(const std::filesystem::path& file, const TetMesh& mesh)
{
    const std::size_t nodes = mesh.vertices.size();
    const std::size_t tets = mesh.tets.size();
    std::string text = fmt::format("$MeshFormat\n4.1 0 8\n$EndMeshFormat\n"
                                   "$Nodes\n1 {0} 1 {0}\n3 1 0 {0}\n",
                                   nodes);
    const auto out = std::back_inserter(text);
    for (std::size_t i = 1; i <= nodes; ++i)
    {
        fmt::format_to(out, "{}\n", i);
    }
    for (const Vec3& p : mesh.vertices)
    {
        fmt::format_to(out, "{} {} {}\n", p.x, p.y, p.z); // the fewest digits that give the same bits
    }
    fmt::format_to(out, "$EndNodes\n$Elements\n1 {0} 1 {0}\n3 1 4 {0}\n", tets);
    for (std::size_t i = 0; i < tets; ++i)
    {
        const Tet& t = mesh.tets[i];
        fmt::format_to(out, "{} {} {} {} {}\n", i + 1, t[0] + 1, t[1] + 1, t[2] + 1, t[3] + 1);
    }
    text += "$EndElements\n";
    write_text_atomically(file, text);
}

} // namespace corticle

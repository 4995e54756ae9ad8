// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/tetrahedralize.hpp"

#include "corticle/base/child_process.hpp"
#include "corticle/base/error.hpp"
#include "corticle/geometry/tet_exchange.hpp"
#include "corticle/mesh/sizes.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <new>
#include <optional>

namespace corticle::geometry
{

namespace
{

namespace fs = std::filesystem;

// Measured on spheres of 1,500 to 96,000 nodes, within 1 %.
constexpr double size_per_node = 0.847; // size asked of HXT, over the cube root of the volume it then gives each node
constexpr double tets_per_node = 6.297;
constexpr double tets_less_per_vertex = 3.42; // of the surface

/// The program that meshes: where the environment says, beside this one, where it is installed with this one, or beside
/// the library that this code is in.
fs::path program()
{
    constexpr const char* name = "corticle-tetrahedralize";
    if (const char* named = std::getenv("CORTICLE_TETRAHEDRALIZE"))
    {
        return named;
    }
    const fs::path folder = fs::read_symlink("/proc/self/exe").parent_path();
    std::error_code error;
    for (const fs::path& found : {folder / name, folder.parent_path() / "libexec" / "corticle" / name})
    {
        if (fs::exists(found, error))
        {
            return found;
        }
    }
    Dl_info library{};
    return dladdr(reinterpret_cast<const void*>(&program), &library) == 0
               ? folder / name
               : fs::absolute(library.dli_fname).parent_path() / name;
}

TetRequest request_for(const TriangleMesh& surface, double size)
{
    TetRequest request;
    request.size = {size};
    for (const Vec3& v : surface.vertices)
    {
        request.coordinates.insert(request.coordinates.end(), {v.x, v.y, v.z});
    }
    for (const Triangle& t : surface.triangles)
    {
        request.corners.insert(request.corners.end(), t.begin(), t.end());
    }
    return request;
}

TetMesh mesh_of(const TetAnswer& answer)
{
    TetMesh mesh;
    for (std::size_t k = 0; k < answer.coordinates.size(); k += 3)
    {
        const double* const at = &answer.coordinates[k];
        mesh.vertices.push_back({at[0], at[1], at[2]});
    }
    for (std::size_t k = 0; k < answer.corners.size(); k += 4)
    {
        const std::int32_t* const corner = &answer.corners[k];
        mesh.tets.push_back({corner[0], corner[1], corner[2], corner[3]});
    }
    return mesh;
}

/// Whether the mesh begins with the surface and has numbers only.
bool fits(const TetMesh& mesh, const TriangleMesh& surface)
{
    return mesh.vertices.size() >= surface.vertices.size() && std::ranges::all_of(mesh.vertices, is_finite) &&
           std::equal(surface.vertices.begin(), surface.vertices.end(), mesh.vertices.begin());
}

/// How a program ended that has made no mesh.
std::string how_it_ended(const ProcessEnd& end)
{
    std::string said = end.errors.substr(0, end.errors.find_last_not_of("\n ") + 1);
    said.erase(0, said.rfind('\n') + 1);
    return end.signal != 0   ? fmt::format("ended by signal {} ({})", end.signal, strsignal(end.signal))
           : end.status == 0 ? fmt::format("its {} bytes of output are no mesh of this surface", end.output.size())
                             : fmt::format("exit status {}{}{}", end.status, said.empty() ? "" : ", ", said);
}

} // namespace

TetMesh tetrahedralize(const TriangleMesh& surface, std::int64_t nodes)
{
    require_triangles(surface);
    // A node on the surface has half a cell.
    const double half = 0.5 * static_cast<double>(surface.vertices.size());
    const double cells = std::max(static_cast<double>(nodes) - half, half);
    const double size = size_per_node * std::cbrt(enclosed_volume(surface.vertices, surface.triangles) / cells);
    const std::string words = program().string();
    const ProcessEnd end = run_program({words}, to_bytes(request_for(surface, size)));
    const auto status = end.signal == 0 ? std::optional(static_cast<TetStatus>(end.status)) : std::nullopt;
    if (status == TetStatus::out_of_memory)
    {
        throw std::bad_alloc();
    }
    if (status == TetStatus::not_filled)
    {
        throw InputError(fmt::format("surface of {} triangles: Gmsh cannot fill it with tetrahedra; expected a closed "
                                     "surface that does not cross itself",
                                     surface.triangles.size()));
    }
    const std::optional<TetAnswer> answer = status == TetStatus::done ? read_answer(end.output) : std::nullopt;
    TetMesh mesh = mesh_of(answer.value_or(TetAnswer{}));
    if (mesh.tets.empty() || !fits(mesh, surface))
    {
        throw RunError(fmt::format("surface of {} triangles: {} has made no tetrahedra: {}", surface.triangles.size(),
                                   words, how_it_ended(end)));
    }
    return mesh;
}

std::int64_t nodes_for_tets(std::int64_t tets, double volume, double area, double edge_per_spacing)
{
    require_positive("tets", static_cast<double>(tets));
    require_positive("volume of the body [mm³]", volume);
    require_positive("area of the body [mm²]", area);
    require_positive("edges over spacings", edge_per_spacing);
    // tets = a V / s³ - b n_s, with n_s = 2 A / (sqrt(3) edge²) vertices of regular triangles on the surface; falls
    // with s, so bisection in the number of nodes V / s³ finds it.
    const double vertices_factor = 2.0 * area / (std::sqrt(3.0) * edge_per_spacing * edge_per_spacing);
    const auto tets_of = [&](double nodes)
    { return tets_per_node * nodes - tets_less_per_vertex * vertices_factor * std::pow(nodes / volume, 2.0 / 3.0); };
    double low = 1.0;
    double high = static_cast<double>(tets) + std::pow(vertices_factor, 3) / (volume * volume);
    while (high - low > 0.5)
    {
        const double middle = 0.5 * (low + high);
        (tets_of(middle) < static_cast<double>(tets) ? low : high) = middle;
    }
    return std::llround(high);
}

} // namespace corticle::geometry

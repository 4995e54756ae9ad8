// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/geometry/tetrahedralize.hpp"

#include "corticle/base/ascending_new.hpp"
#include "corticle/base/child_process.hpp"
#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"

#include <fmt/format.h>
#include <gmsh.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace corticle
{

namespace
{

constexpr int triangle_type = 2; // Gmsh's numbers of element types
constexpr int tet_type = 4;
// Measured on spheres of 1,500 to 96,000 nodes, within 1 %.
constexpr double size_per_node = 0.847; // size asked of HXT, over the cube root of the volume it then gives each node
constexpr double tets_per_node = 6.297;
constexpr double tets_less_per_vertex = 3.42; // of the surface

void add_surface(const TriangleMesh& surface)
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    for (const Vec3& v : surface.vertices)
    {
        tags.push_back(tags.size() + 1);
        coordinates.insert(coordinates.end(), {v.x, v.y, v.z});
    }
    std::vector<std::size_t> corners;
    for (const Triangle& t : surface.triangles)
    {
        for (const std::int32_t vertex : t)
        {
            corners.push_back(static_cast<std::size_t>(vertex) + 1);
        }
    }
    gmsh::model::add("body");
    const int entity = gmsh::model::addDiscreteEntity(2);
    gmsh::model::mesh::addNodes(2, entity, tags, coordinates);
    gmsh::model::mesh::addElementsByType(entity, triangle_type, {}, corners);
    gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop({entity})});
    gmsh::model::geo::synchronize();
}

/// What Gmsh made: the nodes of the surface first, then the others by their tags.
TetMesh read_tets(const TriangleMesh& surface)
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters);
    const std::size_t largest = tags.empty() ? 0 : *std::ranges::max_element(tags);
    std::vector<std::int32_t> node_of(std::max(largest, surface.vertices.size()) + 1, -1);
    TetMesh mesh;
    mesh.vertices = surface.vertices;
    for (std::size_t i = 0; i < surface.vertices.size(); ++i)
    {
        node_of[i + 1] = static_cast<std::int32_t>(i);
    }
    for (std::size_t k = 0; k < tags.size(); ++k)
    {
        if (node_of[tags[k]] < 0)
        {
            node_of[tags[k]] = static_cast<std::int32_t>(mesh.vertices.size());
            mesh.vertices.push_back({coordinates[3 * k], coordinates[3 * k + 1], coordinates[3 * k + 2]});
        }
    }
    std::vector<std::size_t> elements;
    std::vector<std::size_t> corners;
    gmsh::model::mesh::getElementsByType(tet_type, elements, corners);
    for (std::size_t k = 0; k + 3 < corners.size(); k += 4)
    {
        mesh.tets.push_back(
            {node_of[corners[k]], node_of[corners[k + 1]], node_of[corners[k + 2]], node_of[corners[k + 3]]});
    }
    return mesh;
}

template <class T>
void append(std::string& bytes, const std::vector<T>& values)
{
    const std::size_t count = values.size();
    bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
    bytes.append(reinterpret_cast<const char*>(values.data()), count * sizeof(T));
}

template <class T>
std::vector<T> take(std::string_view& bytes)
{
    std::size_t count = 0;
    std::memcpy(&count, bytes.data(), sizeof count);
    std::vector<T> values(count);
    std::memcpy(static_cast<void*>(values.data()), bytes.data() + sizeof count, count * sizeof(T));
    bytes.remove_prefix(sizeof count + count * sizeof(T));
    return values;
}

/// The tets as bytes.
std::string fill(const TriangleMesh& surface, double size)
{
    make_new_ascend();   // Gmsh orders vertices by their addresses, and its tets by that
    set_thread_count(1); // with more, the tets would depend on their number
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::option::setNumber("Mesh.Algorithm3D", 10); // HXT
    gmsh::option::setNumber("Mesh.MeshSizeMax", size);
    add_surface(surface);
    std::srand(1); // HXT draws from the C library
    gmsh::model::mesh::generate(3);
    const TetMesh mesh = read_tets(surface);
    std::string bytes;
    append(bytes, mesh.vertices);
    append(bytes, mesh.tets);
    return bytes;
}

} // namespace

TetMesh tetrahedralize(const TriangleMesh& surface, std::int64_t nodes)
{
    // A node on the surface has half a cell.
    const double half = 0.5 * static_cast<double>(surface.vertices.size());
    const double cells = std::max(static_cast<double>(nodes) - half, half);
    const double size = size_per_node * std::cbrt(enclosed_volume(surface.vertices, surface.triangles) / cells);
    // Gmsh prints, keeps state from call to call and may end the program on a bad surface.
    const std::optional<std::string> bytes = in_child_process([&] { return fill(surface, size); });
    TetMesh mesh;
    if (bytes)
    {
        std::string_view rest = *bytes;
        mesh.vertices = take<Vec3>(rest);
        mesh.tets = take<Tet>(rest);
    }
    if (mesh.tets.empty())
    {
        throw InputError(fmt::format("surface of {} triangles: Gmsh cannot fill it with tetrahedra; expected a closed "
                                     "surface that does not cross itself, and enough memory",
                                     surface.triangles.size()));
    }
    return mesh;
}

std::int64_t nodes_for_tets(std::int64_t tets, double volume, double area, double edge_per_spacing)
{
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

} // namespace corticle

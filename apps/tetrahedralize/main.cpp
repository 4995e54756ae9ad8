// SPDX-License-Identifier: GPL-3.0-or-later
// corticle-tetrahedralize: fills the surface on its standard input with tetrahedra and writes them to its standard
// output (corticle/geometry/tet_exchange.hpp). A program of its own because Gmsh keeps state from call to call, may end
// the process on a bad surface, and gives tets that depend on the addresses of its objects.
#include "ascending_new.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/geometry/tet_exchange.hpp"

#include <gmsh.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>

#include <sys/prctl.h>
#include <unistd.h>

namespace corticle
{

namespace
{

constexpr int triangle_type = 2; // Gmsh's numbers of element types
constexpr int tet_type = 4;

void add_surface(const geometry::TetRequest& request)
{
    std::vector<std::size_t> tags;
    for (std::size_t i = 0; i < request.coordinates.size() / 3; ++i)
    {
        tags.push_back(i + 1);
    }
    std::vector<std::size_t> corners;
    for (const std::int32_t vertex : request.corners)
    {
        corners.push_back(static_cast<std::size_t>(vertex) + 1);
    }
    gmsh::model::add("body");
    const int entity = gmsh::model::addDiscreteEntity(2);
    gmsh::model::mesh::addNodes(2, entity, tags, request.coordinates);
    gmsh::model::mesh::addElementsByType(entity, triangle_type, {}, corners);
    gmsh::model::geo::addVolume({gmsh::model::geo::addSurfaceLoop({entity})});
    gmsh::model::geo::synchronize();
}

/// What Gmsh made: the nodes of the surface first, then the others by their tags.
geometry::TetAnswer read_tets(const geometry::TetRequest& request)
{
    std::vector<std::size_t> tags;
    std::vector<double> coordinates;
    std::vector<double> parameters;
    gmsh::model::mesh::getNodes(tags, coordinates, parameters);
    const std::size_t vertices = request.coordinates.size() / 3;
    const std::size_t largest = tags.empty() ? 0 : *std::ranges::max_element(tags);
    std::vector<std::int32_t> node_of(std::max(largest, vertices) + 1, -1);
    geometry::TetAnswer answer;
    answer.coordinates = request.coordinates;
    for (std::size_t i = 0; i < vertices; ++i)
    {
        node_of[i + 1] = static_cast<std::int32_t>(i);
    }
    for (std::size_t k = 0; k < tags.size(); ++k)
    {
        if (node_of[tags[k]] < 0)
        {
            node_of[tags[k]] = static_cast<std::int32_t>(answer.coordinates.size() / 3);
            answer.coordinates.insert(answer.coordinates.end(), &coordinates[3 * k], &coordinates[3 * k] + 3);
        }
    }
    std::vector<std::size_t> elements;
    std::vector<std::size_t> corners;
    gmsh::model::mesh::getElementsByType(tet_type, elements, corners);
    for (const std::size_t corner : corners)
    {
        answer.corners.push_back(node_of[corner]);
    }
    return answer;
}

geometry::TetAnswer fill(const geometry::TetRequest& request)
{
    make_new_ascend();   // Gmsh orders vertices by their addresses, and its tets by that
    set_thread_count(1); // with more, the tets would depend on their number
    gmsh::initialize(0, nullptr, false);
    gmsh::option::setNumber("General.Terminal", 0);
    gmsh::option::setNumber("General.NumThreads", 1);
    gmsh::option::setNumber("Mesh.RandomSeed", 1);
    gmsh::option::setNumber("Mesh.Algorithm3D", 10); // HXT
    gmsh::option::setNumber("Mesh.MeshSizeMax", request.size[0]);
    add_surface(request);
    std::srand(1); // HXT draws from the C library
    gmsh::model::mesh::generate(3);
    return read_tets(request);
}

/// Until the end of the file or an error.
std::string read_all(int file)
{
    std::string bytes;
    std::array<char, 65536> buffer;
    for (;;)
    {
        const ssize_t count = read(file, buffer.data(), buffer.size());
        if (count == 0 || (count < 0 && errno != EINTR))
        {
            return bytes;
        }
        bytes.append(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    }
}

bool write_all(int file, std::string_view bytes)
{
    while (!bytes.empty())
    {
        const ssize_t count = write(file, bytes.data(), bytes.size());
        if (count < 0 && errno != EINTR)
        {
            return false;
        }
        bytes.remove_prefix(count > 0 ? static_cast<std::size_t>(count) : 0);
    }
    return true;
}

geometry::TetStatus answer_request(int output)
{
    const std::optional<geometry::TetRequest> request = geometry::read_request(read_all(STDIN_FILENO));
    if (!request)
    {
        std::fprintf(stderr,
                     "corticle-tetrahedralize: no surface on the standard input; corticle starts this program\n");
        return geometry::TetStatus::not_understood;
    }
    const geometry::TetAnswer answer = fill(*request);
    const bool is_done = !answer.corners.empty() && write_all(output, geometry::to_bytes(answer));
    return is_done ? geometry::TetStatus::done : geometry::TetStatus::not_filled;
}

geometry::TetStatus guarded(int output)
{
    try
    {
        return answer_request(output);
    }
    catch (const std::bad_alloc&)
    {
        return geometry::TetStatus::out_of_memory;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "%s\n", error.what());
    }
    catch (...) // Gmsh throws words and numbers, too
    {
    }
    return geometry::TetStatus::not_filled;
}

} // namespace

} // namespace corticle

int main()
{
    prctl(PR_SET_PDEATHSIG, SIGKILL); // nobody else waits for the mesh
    const int output = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO); // what libraries print is not part of the mesh
    const corticle::geometry::TetStatus status = corticle::guarded(output);
    std::fflush(nullptr);
    _exit(static_cast<int>(status)); // Gmsh is not taken down: its memory goes with the process
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mesh/tet_mesh.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace corticle
{

namespace
{

/// A face with its nodes in ascending order.
struct Face
{
    std::int32_t low, middle, high;
    std::int32_t tet;
    std::int8_t number; ///< which face of the tet
    bool odd;           ///< outward order is an odd permutation of the ascending one

    auto nodes() const { return std::tie(low, middle, high); }
};

Face sorted_face(const Tet& tet, std::int32_t index, int number)
{
    Triangle t{tet[tet_faces[number][0]], tet[tet_faces[number][1]], tet[tet_faces[number][2]]};
    bool odd = false;
    const auto order = [&](int a, int b)
    {
        if (t[a] > t[b])
        {
            std::swap(t[a], t[b]);
            odd = !odd;
        }
    };
    order(0, 1);
    order(1, 2);
    order(0, 1);
    return {t[0], t[1], t[2], index, static_cast<std::int8_t>(number), odd};
}

std::vector<Face> sorted_faces(const TetMesh& mesh)
{
    std::vector<Face> faces(4 * mesh.tets.size());
    parallel_for(std::ssize(mesh.tets),
                 [&](std::int64_t i)
                 {
                     for (int k = 0; k < 4; ++k)
                     {
                         faces[4 * i + k] = sorted_face(mesh.tets[i], static_cast<std::int32_t>(i), k);
                     }
                 });
    std::sort(faces.begin(), faces.end(),
              [](const Face& a, const Face& b)
              { return std::tie(a.low, a.middle, a.high, a.tet) < std::tie(b.low, b.middle, b.high, b.tet); });
    return faces;
}

} // namespace

double signed_volume(std::span<const Vec3> vertices, const Tet& tet)
{
    const Vec3& a = vertices[tet[0]];
    return dot(cross(vertices[tet[1]] - a, vertices[tet[2]] - a), vertices[tet[3]] - a) / 6.0;
}

std::vector<double> tet_volumes(const TetMesh& mesh)
{
    std::vector<double> volumes(mesh.tets.size());
    parallel_for(std::ssize(mesh.tets),
                 [&](std::int64_t i) { volumes[i] = signed_volume(mesh.vertices, mesh.tets[i]); });
    return volumes;
}

std::vector<double> node_volumes(const TetMesh& mesh)
{
    std::vector<double> volumes(mesh.vertices.size(), 0.0);
    for (const Tet& tet : mesh.tets)
    {
        const double quarter = 0.25 * signed_volume(mesh.vertices, tet);
        for (const std::int32_t node : tet)
        {
            volumes[node] += quarter;
        }
    }
    return volumes;
}

std::vector<Vec3> node_centroids(const TetMesh& mesh)
{
    constexpr double own = 25.0 / 48.0; // barycentric coordinates of the centroid of a quarter
    constexpr double other = 23.0 / 144.0;
    const std::vector<double> volumes = tet_volumes(mesh);
    std::vector<Vec3> moments(mesh.vertices.size());
    std::vector<double> weights(mesh.vertices.size(), 0.0);
    for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    {
        Vec3 sum;
        for (const std::int32_t node : mesh.tets[t])
        {
            sum += mesh.vertices[node];
        }
        for (const std::int32_t node : mesh.tets[t])
        {
            moments[node] += volumes[t] * (other * sum + (own - other) * mesh.vertices[node]);
            weights[node] += volumes[t];
        }
    }
    for (std::size_t node = 0; node < moments.size(); ++node)
    {
        moments[node] = weights[node] > 0.0 ? moments[node] / weights[node] : mesh.vertices[node];
    }
    return moments;
}

double mean_ratio(std::span<const Vec3> vertices, const Tet& tet)
{
    double squared_edges = 0.0;
    for (int a = 0; a < 4; ++a)
    {
        for (int b = a + 1; b < 4; ++b)
        {
            squared_edges += squared_norm(vertices[tet[a]] - vertices[tet[b]]);
        }
    }
    const double root = std::cbrt(3.0 * std::abs(signed_volume(vertices, tet)));
    return squared_edges > 0.0 ? 12.0 * root * root / squared_edges : 0.0;
}

TetNeighbors tet_neighbors(const TetMesh& mesh, FaceFault* fault)
{
    TetNeighbors neighbors(mesh.tets.size(), {-1, -1, -1, -1});
    const std::vector<Face> faces = sorted_faces(mesh);
    FaceFault found;
    for (std::size_t first = 0, last = 0; first < faces.size(); first = last)
    {
        last = first + 1;
        while (last < faces.size() && faces[last].nodes() == faces[first].nodes())
        {
            ++last;
        }
        if (last - first == 1)
        {
            continue;
        }
        const Face& a = faces[first];
        const Face& b = faces[first + 1];
        const bool crowded = last - first > 2;
        const bool same_side = !crowded && a.odd == b.odd;
        found.crowded += crowded;
        found.same_side += same_side;
        if (found.example[0] < 0 && (crowded || same_side))
        {
            found.example = {a.low, a.middle, a.high};
        }
        neighbors[a.tet][a.number] = b.tet;
        neighbors[b.tet][b.number] = a.tet;
    }
    if (fault != nullptr)
    {
        *fault = found;
    }
    return neighbors;
}

TetBoundary boundary_of(const TetMesh& mesh)
{
    return boundary_of(mesh, tet_neighbors(mesh));
}

TetBoundary boundary_of(const TetMesh& mesh, const TetNeighbors& neighbors)
{
    TetBoundary boundary;
    std::vector<std::int32_t> vertex_of(mesh.vertices.size(), -1);
    for (std::size_t i = 0; i < mesh.tets.size(); ++i)
    {
        for (int k = 0; k < 4; ++k)
        {
            if (neighbors[i][k] < 0)
            {
                const Tet& tet = mesh.tets[i];
                const auto& face = tet_faces[k];
                boundary.surface.triangles.push_back({tet[face[0]], tet[face[1]], tet[face[2]]});
                vertex_of[tet[face[0]]] = vertex_of[tet[face[1]]] = vertex_of[tet[face[2]]] = 0;
            }
        }
    }
    for (std::size_t node = 0; node < vertex_of.size(); ++node)
    {
        if (vertex_of[node] == 0)
        {
            vertex_of[node] = static_cast<std::int32_t>(boundary.nodes.size());
            boundary.nodes.push_back(static_cast<std::int32_t>(node));
            boundary.surface.vertices.push_back(mesh.vertices[node]);
        }
    }
    for (Triangle& t : boundary.surface.triangles)
    {
        t = {vertex_of[t[0]], vertex_of[t[1]], vertex_of[t[2]]};
    }
    return boundary;
}

} // namespace corticle

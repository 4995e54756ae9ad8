// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/delaunay.hpp"

#include "corticle/base/error.hpp"

#include <vtkDelaunay3D.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::study
{

namespace
{

/// All tets of the triangulation, in no certain sense.
std::vector<Tet> triangulate(std::span<const Vec3> points)
{
    const vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    for (const Vec3& point : points)
    {
        places->InsertNextPoint(point.x, point.y, point.z);
    }
    const vtkNew<vtkPolyData> input;
    input->SetPoints(places);
    const vtkNew<vtkDelaunay3D> delaunay;
    delaunay->SetInputData(input);
    delaunay->SetTolerance(1e-9); // of the body: points closer than that are one
    delaunay->Update();
    std::vector<Tet> tets;
    vtkUnstructuredGrid* const grid = delaunay->GetOutput();
    for (vtkIdType k = 0; k < grid->GetNumberOfCells(); ++k)
    {
        if (grid->GetCellType(k) == VTK_TETRA)
        {
            vtkIdType count = 0;
            const vtkIdType* corners = nullptr;
            grid->GetCellPoints(k, count, corners);
            Tet tet;
            std::transform(corners, corners + 4, tet.begin(),
                           [](vtkIdType corner) { return static_cast<std::int32_t>(corner); });
            tets.push_back(tet);
        }
    }
    return tets;
}

/// Radius of the ball through the corners; infinite where they are in a plane.
double circumscribed_radius(std::span<const Vec3> points, const Tet& tet)
{
    const Vec3 a = points[tet[1]] - points[tet[0]];
    const Vec3 b = points[tet[2]] - points[tet[0]];
    const Vec3 c = points[tet[3]] - points[tet[0]];
    const Vec3 centre = squared_norm(a) * cross(b, c) + squared_norm(b) * cross(c, a) + squared_norm(c) * cross(a, b);
    return norm(centre) / std::abs(2.0 * dot(a, cross(b, c)));
}

} // namespace

DelaunayBody delaunay_body(std::span<const Vec3> points, double largest, const std::string& name)
{
    DelaunayBody body;
    body.mesh.vertices.assign(points.begin(), points.end());
    std::vector<char> used(points.size(), 0);
    for (Tet tet : triangulate(points))
    {
        if (circumscribed_radius(points, tet) <= largest)
        {
            if (signed_volume(points, tet) < 0.0)
            {
                std::swap(tet[0], tet[1]);
            }
            body.mesh.tets.push_back(tet);
            for (const std::int32_t corner : tet)
            {
                used[corner] = 1;
            }
        }
    }
    if (body.mesh.tets.empty())
    {
        throw InputError(
            fmt::format("{}: Delaunay triangulation of {} points: got no tet, expected points that are not in "
                        "a plane and a limit of more than {:.4g} mm",
                        name, points.size(), largest));
    }
    body.points_left_out = std::ranges::count(used, 0);
    body.boundary = boundary_of(body.mesh);
    return body;
}

} // namespace corticle::study

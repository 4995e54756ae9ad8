// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/shaded_views.hpp"

#include "corticle/view/picture_window.hpp"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkLight.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkOpenGLFXAAPass.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRenderStepsPass.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSSAOPass.h>

namespace corticle::view
{

namespace
{

constexpr double grey = 0.5; // what is lit, so that light can make colours brighter than they are

vtkNew<vtkPolyData> polydata_of(std::span<const Vec3> points, std::span<const Triangle> triangles)
{
    const std::vector<Vec3> normals = vertex_normals(points, triangles);
    vtkNew<vtkPoints> positions;
    vtkNew<vtkFloatArray> directions;
    directions->SetNumberOfComponents(3);
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        positions->InsertNextPoint(points[i].x, points[i].y, points[i].z);
        directions->InsertNextTuple3(normals[i].x, normals[i].y, normals[i].z);
    }
    vtkNew<vtkCellArray> cells;
    for (const Triangle& triangle : triangles)
    {
        const std::array<vtkIdType, 3> corners{triangle[0], triangle[1], triangle[2]};
        cells->InsertNextCell(3, corners.data());
    }
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(positions);
    surface->SetPolys(cells);
    surface->GetPointData()->SetNormals(directions);
    return surface;
}

/// A key light from the upper left and a weaker one beside the camera: sulci stay readable, gyri get a bright and a
/// dark flank.
void add_lights(vtkRenderer* renderer)
{
    const auto add = [&](const Vec3& from, double intensity)
    {
        vtkNew<vtkLight> light;
        light->SetLightTypeToCameraLight();
        light->SetPosition(from.x, from.y, from.z);
        light->SetFocalPoint(0, 0, 0);
        light->SetIntensity(intensity);
        renderer->AddLight(light);
    };
    renderer->SetAutomaticLightCreation(false);
    add({-1.0, 1.1, 1.4}, 0.72);
    add({0.7, -0.4, 1.0}, 0.45);
}

/// Darkens what lies in sulci (ambient occlusion in screen space) and softens edges; `radius` [mm] is how far away a
/// wall still shades.
void add_occlusion(vtkRenderer* renderer, double radius)
{
    vtkNew<vtkRenderStepsPass> steps;
    vtkNew<vtkSSAOPass> occlusion;
    occlusion->SetRadius(radius);
    occlusion->SetBias(0.05 * radius);
    occlusion->SetKernelSize(16);
    occlusion->BlurOn();
    occlusion->SetDelegatePass(steps);
    vtkNew<vtkOpenGLFXAAPass> smooth;
    smooth->SetDelegatePass(occlusion);
    renderer->SetPass(smooth);
}

void look(vtkRenderer* renderer, const View& view, const Canvas& canvas)
{
    const double far = canvas.half_size;
    const Vec3 position = view.center + 10.0 * far * view.from;
    vtkCamera* camera = renderer->GetActiveCamera();
    camera->ParallelProjectionOn();
    camera->SetFocalPoint(view.center.x, view.center.y, view.center.z);
    camera->SetPosition(position.x, position.y, position.z);
    camera->SetViewUp(view.up.x, view.up.y, view.up.z);
    camera->SetParallelScale(0.5 * canvas.height * canvas.mm_per_pixel);
    camera->SetClippingRange(7.0 * far, 13.0 * far);
}

/// Shows the half of the body that the view shows, or all of it.
void cut(vtkActor* body, const View& view)
{
    body->GetMapper()->RemoveAllClippingPlanes();
    if (view.half != 0)
    {
        vtkNew<vtkPlane> plane;
        plane->SetOrigin(view.middle, 0.0, 0.0);
        plane->SetNormal(view.half, 0.0, 0.0);
        body->GetMapper()->AddClippingPlane(plane);
    }
}

/// The body in grey.
vtkNew<vtkActor> body_of(vtkPolyData* surface)
{
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(surface);
    mapper->UseLookupTableScalarRangeOn();
    mapper->InterpolateScalarsBeforeMappingOn();
    vtkNew<vtkActor> body;
    body->SetMapper(mapper);
    body->GetProperty()->SetInterpolationToPhong();
    body->GetProperty()->SetColor(grey, grey, grey);
    body->GetProperty()->SetDiffuse(0.9);
    body->GetProperty()->SetSpecularPower(25);
    return body;
}

vtkNew<vtkDoubleArray> array_of(std::span<const double> scalar, std::size_t count)
{
    vtkNew<vtkDoubleArray> values;
    for (std::size_t i = 0; i < count; ++i)
    {
        values->InsertNextValue(scalar.empty() ? 0.0 : scalar[i]);
    }
    return values;
}

} // namespace

Pictures draw_views(const Body& shape, std::span<const Coloring> colorings, std::span<const View> views,
                    const Canvas& canvas)
{
    vtkRenderWindow* const window = picture_window(canvas.width, canvas.height);
    vtkNew<vtkRenderer> renderer;
    const vtkNew<vtkPolyData> surface = polydata_of(shape.points, shape.triangles);
    const vtkNew<vtkActor> body = body_of(surface);
    renderer->AddActor(body);
    add_lights(renderer);
    window->AddRenderer(renderer);

    body->GetProperty()->SetAmbient(0.16);
    body->GetProperty()->SetSpecular(0.1);
    body->GetMapper()->ScalarVisibilityOff();
    renderer->SetBackground(grey, grey, grey);
    add_occlusion(renderer, 0.12 * canvas.half_size);
    Pictures shades;
    for (const View& view : views)
    {
        look(renderer, view, canvas);
        cut(body, view);
        shades.push_back(grab_picture(window));
    }

    body->GetProperty()->LightingOff();
    body->GetProperty()->SetAmbient(1.0);
    body->GetProperty()->SetDiffuse(0.0);
    body->GetMapper()->ScalarVisibilityOn();
    renderer->SetBackground(canvas.background, canvas.background, canvas.background);
    renderer->GetPass()->ReleaseGraphicsResources(window);
    renderer->SetPass(nullptr);
    renderer->UseFXAAOn();
    Pictures pictures;
    for (const Coloring& coloring : colorings)
    {
        vtkNew<vtkLookupTable> colors;
        fill_lookup_table(colors, *coloring.scale);
        body->GetMapper()->SetLookupTable(colors);
        body->GetMapper()->SetInterpolateScalarsBeforeMapping(coloring.scale->map != ColorMap::regions);
        surface->GetPointData()->SetScalars(array_of(coloring.scalar, shape.points.size()));
        for (std::size_t i = 0; i < views.size(); ++i)
        {
            look(renderer, views[i], canvas);
            cut(body, views[i]);
            pictures.push_back(grab_picture(window));
            multiply(pictures.back(), shades[i], 1.0 / grey);
        }
    }
    window->RemoveRenderer(renderer);
    return pictures;
}

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"
#include "corticle/base/error.hpp"
#include "corticle/config/parameters/choices.hpp"
#include "corticle/formats/surfaces/surface_reader.hpp"
#include "corticle/formats/surfaces/surface_writer.hpp"
#include "corticle/formats/volumes/nifti_write.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/phantom.hpp"
#include "corticle/study/comparison/real_surface.hpp"
#include "gate.hpp"
#include "module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include <algorithm>

namespace corticle::python
{

namespace
{

/// The enumerator of a name, as in cases and on the command line. @throws InputError
template <class Enum>
Enum choice(const char* what, const std::string& name)
{
    const std::vector<std::string> names = config::names<Enum>();
    const auto found = std::ranges::find(names, name);
    if (found == names.end())
    {
        throw InputError(fmt::format("{}: got \"{}\", expected \"{}\"", what, name, fmt::join(names, "\" or \"")));
    }
    return static_cast<Enum>(found - names.begin());
}

TriangleMesh mesh_of(const Numbers& vertices, const Indices& triangles)
{
    TriangleMesh mesh{points_of(vertices, "vertices"), triangles_of(triangles)};
    return mesh;
}

py::dict rows_of(const std::vector<metrics::SurfaceRow>& rows)
{
    py::dict measures;
    for (const metrics::SurfaceRow& row : rows)
    {
        measures[py::str(row.key)] = row.value;
    }
    return measures;
}

py::dict measure_surface(const Numbers& vertices, const Indices& triangles, const std::string& outer)
{
    metrics::FoldOptions options;
    options.outer = choice<metrics::OuterSurface>("outer", outer);
    const TriangleMesh mesh = mesh_of(vertices, triangles);
    std::vector<metrics::SurfaceRow> rows;
    {
        const Work work;
        geometry::require_valid_surface(mesh, "the surface");
        rows = metrics::surface_rows(mesh.vertices, mesh.triangles, options);
    }
    return rows_of(rows);
}

py::tuple measure_file(const std::string& file, const std::vector<std::int64_t>& labels, const std::string& unit,
                       const std::string& coordinates, const std::string& outer)
{
    metrics::FoldOptions folds;
    folds.outer = choice<metrics::OuterSurface>("outer", outer);
    study::RealSurfaceOptions options;
    options.unit = choice<formats::UnitOfLength>("unit", unit);
    options.coordinates = choice<formats::Coordinates>("coordinates", coordinates);
    options.mask.labels = labels;
    std::vector<metrics::SurfaceRow> rows;
    std::vector<std::string> warnings;
    {
        const Work work;
        study::RealSurfaceReading reading = study::read_real_surface(file, options);
        rows = study::surface_rows(reading, folds);
        warnings = std::move(reading.warnings);
    }
    return py::make_tuple(rows_of(rows), warnings);
}

py::dict fold_fields(const Numbers& vertices, const Indices& triangles, const std::string& outer)
{
    metrics::FoldOptions options;
    options.outer = choice<metrics::OuterSurface>("outer", outer);
    const TriangleMesh mesh = mesh_of(vertices, triangles);
    metrics::FoldFields fields;
    {
        const Work work;
        geometry::require_valid_surface(mesh, "the surface");
        fields = metrics::fold_fields(mesh.vertices, mesh.triangles, options);
    }
    py::dict arrays;
    arrays["mean_curvature"] = array_of(std::move(fields.curvature.mean));
    arrays["gaussian_curvature"] = array_of(std::move(fields.curvature.gaussian));
    arrays["shape_index"] = array_of(std::move(fields.curvature.shape_index));
    arrays["curvedness"] = array_of(std::move(fields.curvature.curvedness));
    arrays["sulcal_depth"] = array_of(std::move(fields.sulcal_depth));
    arrays["local_gyrification"] = array_of(std::move(fields.local_gyrification));
    return arrays;
}

py::tuple read_surface(const std::string& file, const std::string& unit, const std::string& coordinates)
{
    formats::SurfaceFileOptions options;
    options.scale = formats::millimetres_per(choice<formats::UnitOfLength>("unit", unit));
    options.coordinates = choice<formats::Coordinates>("coordinates", coordinates);
    TriangleMesh mesh = formats::read_surface(file, options);
    return py::make_tuple(array_of(std::move(mesh.vertices)), array_of(std::move(mesh.triangles)));
}

void write_ply(const std::string& file, const Numbers& vertices, const Indices& triangles)
{
    const TriangleMesh mesh = mesh_of(vertices, triangles);
    formats::write_surface_ply(file, mesh.vertices, mesh.triangles);
}

} // namespace

void bind_surfaces(py::module_& module)
{
    module.def("measure_surface", &measure_surface, py::arg("vertices").noconvert(), py::arg("triangles").noconvert(),
               py::arg("outer"));
    module.def("measure_file", &measure_file, py::arg("file"), py::arg("labels"), py::arg("unit"),
               py::arg("coordinates"), py::arg("outer"));
    module.def("fold_fields", &fold_fields, py::arg("vertices").noconvert(), py::arg("triangles").noconvert(),
               py::arg("outer"));
    module.def("read_surface", &read_surface, py::arg("file"), py::arg("unit"), py::arg("coordinates"));
    module.def("write_ply", &write_ply, py::arg("file"), py::arg("vertices").noconvert(),
               py::arg("triangles").noconvert());
    module.def(
        "write_phantom",
        [](const std::string& file, double length, double voxel) {
            formats::write_nifti(file, imaging::make_brain_phantom({length, voxel}));
        },
        py::arg("file"), py::arg("length"), py::arg("voxel"));
}

} // namespace corticle::python

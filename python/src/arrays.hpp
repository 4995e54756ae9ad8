// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/mesh/triangle_mesh.hpp"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <span>
#include <vector>

// numpy arrays of the library's arrays, and back.

namespace corticle::python
{

namespace py = pybind11;

/// Arrays as Python hands them over: of this type and in C order; the Python side has converted and checked them.
using Numbers = py::array_t<double, py::array::c_style>;
using Indices = py::array_t<std::int32_t, py::array::c_style>;

/// Read-only views without a copy, of memory that `owner` keeps alive: (n, 3), (n,), (n,), (m, 3).
py::array view(std::span<const Vec3> values, const py::object& owner);
py::array view(std::span<const double> values, const py::object& owner);
py::array view(std::span<const std::int32_t> values, const py::object& owner);
py::array view(std::span<const Triangle> values, const py::object& owner);

/// An object that keeps `kept` alive.
template <class T>
py::capsule owner_of(std::shared_ptr<T> kept)
{
    return {new std::shared_ptr<T>(std::move(kept)),
            [](void* pointer) { delete static_cast<std::shared_ptr<T>*>(pointer); }};
}

/// A read-only array that takes over the values.
template <class T>
py::array array_of(std::vector<T> values)
{
    auto kept = std::make_shared<const std::vector<T>>(std::move(values));
    const std::span<const T> all(*kept);
    return view(all, owner_of(std::move(kept)));
}

/// (n, 3, 3), row and column last; read-only.
py::array array_of(std::vector<Mat3> values);

/// (n, 3) as points. @throws InputError for another shape, which `what` is called
std::vector<Vec3> points_of(const Numbers& array, const char* what);
/// (m, 3) as triangles. @throws InputError for another shape
std::vector<Triangle> triangles_of(const Indices& array);

} // namespace corticle::python

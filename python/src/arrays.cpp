// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

namespace corticle::python
{

namespace
{

constexpr py::ssize_t size_of_double = sizeof(double);
constexpr py::ssize_t size_of_index = sizeof(std::int32_t);

template <class T>
py::array read_only(std::vector<py::ssize_t> shape, std::vector<py::ssize_t> strides, const T* first,
                    const py::object& owner)
{
    py::array array(py::dtype::of<T>(), std::move(shape), std::move(strides), first, owner);
    py::detail::array_proxy(array.ptr())->flags &= ~py::detail::npy_api::NPY_ARRAY_WRITEABLE_;
    return array;
}

std::string shape_text(const py::array& array)
{
    std::string text;
    for (py::ssize_t k = 0; k < array.ndim(); ++k)
    {
        text += fmt::format("{}{}", k == 0 ? "" : ", ", array.shape(k));
    }
    return fmt::format("({}{})", text, array.ndim() == 1 ? "," : "");
}

void require_triples(const py::array& array, const char* what)
{
    if (array.ndim() != 2 || array.shape(1) != 3)
    {
        throw InputError(fmt::format("{}: got an array of shape {}, expected (n, 3)", what, shape_text(array)));
    }
}

} // namespace

py::array view(std::span<const Vec3> values, const py::object& owner)
{
    return read_only<double>({std::ssize(values), 3}, {sizeof(Vec3), size_of_double},
                             reinterpret_cast<const double*>(values.data()), owner);
}

py::array view(std::span<const double> values, const py::object& owner)
{
    return read_only<double>({std::ssize(values)}, {size_of_double}, values.data(), owner);
}

py::array view(std::span<const std::int32_t> values, const py::object& owner)
{
    return read_only<std::int32_t>({std::ssize(values)}, {size_of_index}, values.data(), owner);
}

py::array view(std::span<const Triangle> values, const py::object& owner)
{
    return read_only<std::int32_t>({std::ssize(values), 3}, {sizeof(Triangle), size_of_index},
                                   reinterpret_cast<const std::int32_t*>(values.data()), owner);
}

py::array array_of(std::vector<Mat3> values)
{
    auto kept = std::make_shared<const std::vector<Mat3>>(std::move(values));
    const auto* const first = reinterpret_cast<const double*>(kept->data());
    const py::ssize_t count = std::ssize(*kept);
    return read_only<double>({count, 3, 3}, {sizeof(Mat3), size_of_double, sizeof(Vec3)}, first,
                             owner_of(std::move(kept)));
}

std::vector<Vec3> points_of(const Numbers& array, const char* what)
{
    require_triples(array, what);
    const auto values = array.unchecked<2>();
    std::vector<Vec3> points(static_cast<std::size_t>(values.shape(0)));
    for (py::ssize_t i = 0; i < values.shape(0); ++i)
    {
        points[static_cast<std::size_t>(i)] = {values(i, 0), values(i, 1), values(i, 2)};
    }
    return points;
}

std::vector<Triangle> triangles_of(const Indices& array)
{
    require_triples(array, "triangles");
    const auto values = array.unchecked<2>();
    std::vector<Triangle> triangles(static_cast<std::size_t>(values.shape(0)));
    for (py::ssize_t i = 0; i < values.shape(0); ++i)
    {
        triangles[static_cast<std::size_t>(i)] = {values(i, 0), values(i, 1), values(i, 2)};
    }
    return triangles;
}

} // namespace corticle::python

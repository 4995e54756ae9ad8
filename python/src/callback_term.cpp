// SPDX-License-Identifier: GPL-3.0-or-later
#include "callback_term.hpp"

#include "arrays.hpp"
#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::python
{

namespace
{

/// The function may keep what it is shown, hence a copy.
py::array copied(std::span<const Vec3> values)
{
    return array_of(std::vector<Vec3>(values.begin(), values.end()));
}

double energy_of(const py::object& object, const std::string& name)
{
    const double energy = PyFloat_AsDouble(object.ptr());
    if (PyErr_Occurred() != nullptr)
    {
        throw py::error_already_set();
    }
    if (!std::isfinite(energy))
    {
        throw InputError(fmt::format("force \"{}\": got the energy {}, expected a finite number", name, energy));
    }
    return energy;
}

} // namespace

mechanics::Contribution CallbackTerm::add(const mechanics::StepContext& context, std::span<Vec3> forces)
{
    const py::gil_scoped_acquire locked;
    py::object answer = function_(context.t, copied(context.x), copied(context.v));
    energy_ = 0.0;
    if (py::isinstance<py::tuple>(answer) && py::len(answer) == 2)
    {
        const auto both = answer.cast<py::tuple>();
        energy_ = energy_of(both[1], name_);
        answer = both[0];
    }
    const auto array = Numbers::ensure(answer);
    if (!array)
    {
        throw InputError(fmt::format("force \"{}\": got an object of type {}, expected an array (n, 3) of forces",
                                     name_, Py_TYPE(answer.ptr())->tp_name));
    }
    const std::vector<Vec3> added = points_of(array, fmt::format("force \"{}\"", name_).c_str());
    if (added.size() != forces.size())
    {
        throw InputError(fmt::format("force \"{}\": got {} forces, expected one for each of {} particles", name_,
                                     added.size(), forces.size()));
    }
    if (const auto bad = std::ranges::find_if_not(added, is_finite); bad != added.end())
    {
        throw InputError(fmt::format("force \"{}\": got ({}, {}, {}) at particle {}, expected finite numbers", name_,
                                     bad->x, bad->y, bad->z, bad - added.begin()));
    }
    for (std::size_t i = 0; i < forces.size(); ++i)
    {
        forces[i] += added[i];
    }
    mechanics::Contribution contribution;
    contribution.stable_step = stable_step_;
    return contribution;
}

} // namespace corticle::python

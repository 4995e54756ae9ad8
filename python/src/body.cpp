// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/mesh/sizes.hpp"
#include "gate.hpp"
#include "module.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>

namespace corticle::python
{

namespace
{

std::shared_ptr<const Body> make(ResolvedCase resolved, prepare::Preparation made)
{
    return std::make_shared<const Body>(
        Body{std::move(resolved), std::make_shared<const model::Model>(std::move(made.model)), std::move(made.report)});
}

std::shared_ptr<const Body> prepare_body(ResolvedCase resolved)
{
    const Work work;
    config::identify_inputs(resolved.options);
    resolved.text = config::to_toml(resolved.options);
    prepare::Preparation made = prepare::prepare_body(resolved.options);
    return make(std::move(resolved), std::move(made));
}

/// The body as it is arranged, with the tissue and the pairs of these options.
std::shared_ptr<const Body> connected(const Body& body, const ResolvedCase& resolved, prepare::Preparation made)
{
    made.model.tissue.given_theta.clear();
    if (made.model.fem)
    {
        made.model.fem->tissue.given_theta.clear();
    }
    made.report = body.report;
    made.report.warnings.clear();
    prepare::connect_body(resolved.options, made);
    return make(resolved, std::move(made));
}

using Field = std::optional<Numbers>;

/// One number a particle, from `least` on. @throws InputError
std::vector<double> field_of(const Numbers& array, const char* what, std::size_t particles, double least, bool is_open)
{
    if (array.ndim() != 1)
    {
        throw InputError(fmt::format("{}: got an array of {} dimensions, expected one number for each of {} particles",
                                     what, array.ndim(), particles));
    }
    require_size(what, static_cast<std::size_t>(array.shape(0)), particles);
    std::vector<double> values(array.data(), array.data() + array.size());
    const auto is_wrong = [&](double value)
    { return !std::isfinite(value) || (is_open ? value <= least : value < least); };
    if (const auto bad = std::ranges::find_if(values, is_wrong); bad != values.end())
    {
        throw InputError(fmt::format("{}: got {} at particle {}, expected finite numbers {} {}", what, *bad,
                                     bad - values.begin(), is_open ? ">" : ">=", least));
    }
    return values;
}

/// Directions at the particles. @throws InputError where the case has no fibres that these could be
std::vector<Vec3> fibres_of(const Numbers& array, const Body& body)
{
    if (!body.resolved.options.tissue.remodelling.has_fibres())
    {
        throw InputError(
            "fibres: the case has none (fibres.direction = \"none\"); expected another direction, in place of "
            "which these are taken");
    }
    std::vector<Vec3> fibres = points_of(array, "fibres");
    require_size("fibres", fibres.size(), body.model->cloud.positions.size());
    require_finite("fibres", fibres);
    if (std::ranges::all_of(fibres, [](const Vec3& fibre) { return norm(fibre) == 0.0; }))
    {
        throw InputError("fibres: got directions of length 0 alone, expected some that are not");
    }
    return fibres;
}

/// The body with other fields of the tissue at its particles; those not given stay.
std::shared_ptr<const Body> with_fields(const Body& body, const Field& growth, const Field& thickness,
                                        const Field& fibres)
{
    if (body.model->fem)
    {
        throw InputError("fields at particles: the body is of tets (solver.method = \"fem\"), whose tissue is in "
                         "elements; expected a body of particles, or maps at the vertices of the surface");
    }
    const std::size_t particles = body.model->cloud.positions.size();
    prepare::Preparation made{*body.model, {}};
    if (growth)
    {
        made.model.tissue.mapped_rate = field_of(*growth, "growth", particles, 0.0, false);
    }
    if (thickness)
    {
        made.model.tissue.thickness = field_of(*thickness, "thickness [mm]", particles, 0.0, true);
    }
    if (fibres)
    {
        made.model.tissue.given_fibre = fibres_of(*fibres, body);
    }
    const Work work;
    return connected(body, body.resolved, std::move(made));
}

/// A read-only array of something that the body holds.
template <class Get>
auto part(Get get)
{
    return [get](const std::shared_ptr<const Body>& body)
    { return view(std::span(get(*body->model)), owner_of(body)); };
}

std::shared_ptr<Body> mutable_pointer(const std::shared_ptr<const Body>& body)
{
    return std::const_pointer_cast<Body>(body); // Python sees what is bound below, which changes nothing
}

} // namespace

std::shared_ptr<const Body> body_for(const std::shared_ptr<const Body>& body, const ResolvedCase& resolved)
{
    if (config::differing_keys(body->resolved.text, resolved.text).empty())
    {
        return body;
    }
    const std::vector<std::string> other = config::differing_body_keys(body->resolved.text, resolved.text);
    if (!other.empty())
    {
        throw InputError(fmt::format("the body was prepared for another case ({}); expected the same [geometry] and "
                                     "[map], or a body prepared anew",
                                     fmt::join(other, "; ")));
    }
    return connected(*body, resolved, {*body->model, {}});
}

void bind_body(py::module_& module)
{
    using model::Model;
    using Shared = const std::shared_ptr<const Body>&;
    py::class_<Body, std::shared_ptr<Body>>(module, "Body")
        .def_property_readonly("source", [](const Body& body) { return body.report.source; })
        .def_property_readonly("notes", [](const Body& body) { return body.report.notes; })
        .def_property_readonly("warnings", [](const Body& body) { return body.report.warnings; })
        .def_property_readonly("spacing", [](const Body& body) { return body.model->cloud.spacing; })
        .def_property_readonly("positions", part([](const Model& m) -> auto& { return m.cloud.positions; }))
        .def_property_readonly("volumes", part([](const Model& m) -> auto& { return m.cloud.volumes; }))
        .def_property_readonly("depth", part([](const Model& m) -> auto& { return m.tissue.depth; }))
        .def_property_readonly("normals", part([](const Model& m) -> auto& { return m.tissue.normal; }))
        .def_property_readonly("growth", part([](const Model& m) -> auto& { return m.tissue.mapped_rate; }))
        .def_property_readonly("thickness", part([](const Model& m) -> auto& { return m.tissue.thickness; }))
        .def_property_readonly("fibres", part([](const Model& m) -> auto& { return m.tissue.fibre; }))
        .def_property_readonly("surface_particles",
                               part([](const Model& m) -> auto& { return m.cloud.surface_particles; }))
        .def_property_readonly("vertices", part([](const Model& m) -> auto& { return m.surface.vertices; }))
        .def_property_readonly("triangles", part([](const Model& m) -> auto& { return m.cloud.surface_triangles; }))
        .def(
            "with_fields",
            [](Shared body, const Field& growth, const Field& thickness, const Field& fibres)
            { return mutable_pointer(with_fields(*body, growth, thickness, fibres)); },
            py::arg("growth"), py::arg("thickness"), py::arg("fibres"));
    module.def(
        "prepare", [](const ResolvedCase& resolved) { return mutable_pointer(prepare_body(resolved)); },
        py::arg("case"));
}

} // namespace corticle::python

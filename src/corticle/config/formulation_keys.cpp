// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/formulation_keys.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::config
{

namespace
{

struct ThesisValue
{
    const char* key;
    Value value;
};

/// What the thesis does otherwise, besides its equations of motion; Table 1 where it varies something.
const std::array<ThesisValue, 12>& thesis_values()
{
    static const std::array<ThesisValue, 12> values{{
        {"geometry.volumes", std::string("neighbour_count")},
        {"geometry.normals", std::string("divisions")},
        {"tissue.layer", std::string("binary")},
        {"tissue.lambda", 0.75},
        {"tissue.barrier_J", 0.0},
        {"solver.kernel_mm", 3.5},
        {"solver.zeta", 0.0},
        {"solver.integrator", std::string("rk4")},
        {"solver.time_step", 2e-5},
        {"solver.damping", 0.0},
        {"solver.max_halvings", std::int64_t{0}},
        {"contact.enabled", false},
    }};
    return values;
}

} // namespace

void settle_formulation(Options& options, const std::function<std::string(std::string_view)>& place)
{
    if (options.formulation == thesis::Formulation::thesis)
    {
        for (const ThesisValue& entry : thesis_values())
        {
            const bool is_moot =
                entry.key == std::string_view("tissue.lambda") && options.tissue.layer != material::Layer::binary;
            if (place(entry.key).empty() && !is_moot)
            {
                find_parameter(entry.key)->set(options, entry.value);
            }
        }
        return;
    }
    for (const Parameter& parameter : parameters())
    {
        if (parameter.section() == "thesis" && !place(parameter.key).empty())
        {
            throw InputError(fmt::format("{}{} is given, but solver.formulation{} is \"corrected\": expected "
                                         "formulation = \"thesis\"",
                                         parameter.key, place(parameter.key), place("solver.formulation")));
        }
    }
}

} // namespace corticle::config

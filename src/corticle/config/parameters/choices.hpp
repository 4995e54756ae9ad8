// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/material/thickness_presets.hpp"
#include "corticle/mechanics/boundary/options.hpp"
#include "corticle/metrics/fold_measures.hpp"

#include <string>
#include <vector>

// What the enumerators of options are called in cases and on the command line.

namespace corticle::config
{

/// Names of enumerators, in their order.
template <class Enum>
std::vector<std::string> names();

template <>
inline std::vector<std::string> names<model::Method>()
{
    return {"tlsph", "fem"};
}
template <>
inline std::vector<std::string> names<material::Layer>()
{
    return {"smooth", "binary"};
}
template <>
inline std::vector<std::string> names<material::ThicknessPreset>()
{
    std::vector<std::string> all{"none"};
    for (const material::PresetThickness& row : material::thickness_presets())
    {
        all.emplace_back(row.name);
    }
    return all;
}
template <>
inline std::vector<std::string> names<material::BulkRule>()
{
    return {"per_tissue", "uniform"};
}
template <>
inline std::vector<std::string> names<material::GrowthLaw>()
{
    return {"linear", "gompertz"};
}
template <>
inline std::vector<std::string> names<material::GrowthSource>()
{
    return {"keys", "fetal", "table"};
}
template <>
inline std::vector<std::string> names<material::NormalFrame>()
{
    return {"reference", "current"};
}
template <>
inline std::vector<std::string> names<material::FibreField>()
{
    return {"none", "radial", "depth", "file"};
}
template <>
inline std::vector<std::string> names<material::GestationalClock>()
{
    return {"none", "wang", "cubic"};
}
template <>
inline std::vector<std::string> names<material::LengthLaw>()
{
    return {"none", "hyperbolic", "quadratic"};
}
template <>
inline std::vector<std::string> names<material::SizedState>()
{
    return {"reference", "body"};
}
template <>
inline std::vector<std::string> names<thesis::Formulation>()
{
    return {"corrected", "thesis"};
}
template <>
inline std::vector<std::string> names<thesis::GrowthEntry>()
{
    return {"multiplied", "divided"};
}
template <>
inline std::vector<std::string> names<thesis::ForceForm>()
{
    return {"difference", "conservative"};
}
template <>
inline std::vector<std::string> names<thesis::KernelGradient>()
{
    return {"plain", "displacement", "corrected"};
}
template <>
inline std::vector<std::string> names<dynamics::Integrator>()
{
    return {"symplectic_euler", "rk4"};
}
template <>
inline std::vector<std::string> names<formats::Coordinates>()
{
    return {"scanner", "file"};
}
template <>
inline std::vector<std::string> names<prepare::Shape>()
{
    return {prepare::shape_names.begin(), prepare::shape_names.end()};
}
template <>
inline std::vector<std::string> names<boundary::SupportKind>()
{
    return {"none", "fixed", "roller", "displacement"};
}
template <>
inline std::vector<std::string> names<boundary::Face>()
{
    return {boundary::face_names.begin(), boundary::face_names.end()};
}
template <>
inline std::vector<std::string> names<boundary::Axes>()
{
    return {boundary::axes_names.begin(), boundary::axes_names.end()};
}
template <>
inline std::vector<std::string> names<boundary::SkullShape>()
{
    return {"none", "offset", "ellipsoid", "file"};
}
template <>
inline std::vector<std::string> names<boundary::SkullKind>()
{
    return {"rigid", "elastic"};
}
template <>
inline std::vector<std::string> names<boundary::Fluid>()
{
    return {"none", "constant", "conserved"};
}
template <>
inline std::vector<std::string> names<prepare::Arrangement>()
{
    return {prepare::arrangement_names.begin(), prepare::arrangement_names.end()};
}
template <>
inline std::vector<std::string> names<prepare::VolumeRule>()
{
    return {"cells", "neighbour_count"};
}
template <>
inline std::vector<std::string> names<prepare::NormalRule>()
{
    return {"surface", "divisions"};
}
template <>
inline std::vector<std::string> names<formats::UnitOfLength>()
{
    return {"mm", "cm", "m"};
}
template <>
inline std::vector<std::string> names<imaging::Hemisphere>()
{
    return {imaging::hemisphere_names.begin(), imaging::hemisphere_names.end()};
}
template <>
inline std::vector<std::string> names<PictureRule>()
{
    return {"on", "off"};
}
template <>
inline std::vector<std::string> names<geometry::Repair>()
{
    return {"auto", "wrap", "none"};
}
template <>
inline std::vector<std::string> names<metrics::OuterSurface>()
{
    return {"hull", "closed"};
}

} // namespace corticle::config

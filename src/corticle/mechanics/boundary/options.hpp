// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace corticle::boundary
{

enum class SupportKind
{
    none,        ///< not given
    fixed,       ///< does not move
    roller,      ///< does not move along `axes`
    displacement ///< is moved along `axes`
};

/// A face of the box around the body.
enum class Face
{
    none,
    x_min,
    x_max,
    y_min,
    y_max,
    z_min,
    z_max
};

/// Along which axes a support holds.
enum class Axes
{
    none, ///< not given: the normal of the plane
    x,
    y,
    z,
    xy,
    xz,
    yz,
    xyz
};

/// Names in a case.
inline constexpr std::array face_names{"none", "x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
inline constexpr std::array axes_names{"none", "x", "y", "z", "xy", "xz", "yz", "xyz"};
constexpr const char* name_of(Face face)
{
    return face_names[static_cast<std::size_t>(face)];
}

/// One support, [[support]] of a case: which nodes it holds, along which axes, and where it moves them.
struct SupportOptions
{
    SupportKind kind = SupportKind::none;
    Face plane = Face::none;                              ///< nodes of this face; none: of the box below
    std::array<double, 3> low_mm{-1e9, -1e9, -1e9};       ///< corners of a box of nodes
    std::array<double, 3> high_mm{1e9, 1e9, 1e9};         ///< the same
    Axes axes = Axes::none;                               ///< of a roller or a displacement
    std::array<double, 3> displacement_mm{0.0, 0.0, 0.0}; ///< reached at the end of the ramp
    double start = 0.0;                                   ///< of the ramp [t]
    double end = 1.0;                                     ///< of the ramp [t]
    std::optional<double> start_week;                     ///< instead of start, with a clock
    std::optional<double> end_week;                       ///< instead of end, with a clock
};

inline constexpr std::size_t most_supports = 8;

/// Where the skull comes from.
enum class SkullShape
{
    none,
    offset,    ///< at a distance from the body's surface
    ellipsoid, ///< about a centre
    file       ///< a closed surface
};

enum class SkullKind
{
    rigid,  ///< where its own growth says
    elastic ///< every vertex on a spring to where its own growth says
};

/// The fluid that presses on the brain.
enum class Fluid
{
    none,
    constant, ///< of a given pressure
    conserved ///< of a given volume, between brain and skull
};

/// Skull and fluid (keys under [boundary]).
struct BoundaryOptions
{
    SkullShape shape = SkullShape::none;
    double offset_mm = 2.0;                               ///< offset
    std::array<double, 3> semi_axes_mm{16.0, 13.0, 11.0}; ///< ellipsoid
    std::array<double, 3> centre_mm{0.0, 0.0, 0.0};       ///< ellipsoid
    std::string file;                                     ///< file
    SkullKind kind = SkullKind::rigid;
    double stiffness = 1.0;     ///< of an elastic one: pressure over displacement [mu_w / mm]
    std::vector<double> times;  ///< of scales [t]
    std::vector<double> weeks;  ///< of scales, instead of times, with a clock
    std::vector<double> scales; ///< size at these times over that at the start; empty: 1
    Fluid fluid = Fluid::none;
    double pressure = 0.1;           ///< of a constant one [mu_w]
    double pressure_time = 0.05;     ///< t that it takes to rise from 0 at the start
    double bulk_modulus = 5.0;       ///< of a conserved one [mu_w]
    double ventricle_pressure = 0.0; ///< of the fluid in the ventricles above that outside [mu_w]
};

} // namespace corticle::boundary

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/cloud/cloud_options.hpp"
#include "corticle/contact/options.hpp"
#include "corticle/dynamics/options.hpp"
#include "corticle/tissue/options.hpp"
#include "corticle/tlsph/options.hpp"

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace corticle
{

/// Where the body comes from.
struct GeometryOptions
{
    std::string shape = "sphere";                         ///< "sphere" | "ellipsoid" | "file"
    double radius_mm = 12.496;                            ///< sphere
    std::array<double, 3> semi_axes_mm{15.0, 12.0, 10.0}; ///< ellipsoid
    std::string file;                                     ///< closed triangulated surface: STL, OBJ, PLY, OFF, VTP
    std::string unit = "mm";                              ///< of the file: "mm" | "cm" | "m"
    std::optional<double> spacing_mm;                     ///< either this
    std::optional<std::int64_t> particles;                ///< or this
    std::int64_t seed = 1;
};

struct OutputOptions
{
    std::int64_t count = 10;     ///< evenly spaced in t, besides t = 0
    std::vector<double> times;   ///< instead of count
    std::string pictures = "on"; ///< "on" | "off"
    std::vector<double>
        picture_times; ///< output times that get pictures (the nearest); empty: about five, evenly spaced
    double checkpoint_minutes = 5.0;
};

struct TimeOptions
{
    double end = 1.0; ///< growth time t at which the run ends
};

/// What the user chose.
struct Options
{
    GeometryOptions geometry;
    TissueOptions tissue;
    TlsphOptions tlsph;       ///< keys under [solver]
    ContactOptions contact;   ///< keys under [contact]
    DynamicsOptions dynamics; ///< keys under [solver]
    TimeOptions time;
    OutputOptions output;
};

} // namespace corticle

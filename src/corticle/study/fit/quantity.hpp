// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/study/comparison/real_surface.hpp"
#include "corticle/study/fit/table_reader.hpp"

namespace corticle::fit
{

/// A number that a run predicts.
struct Quantity
{
    enum class Place
    {
        end, ///< of the run: a key of summary.json
        t,
        week
    };
    std::string measure;
    Place place = Place::end;
    double at = 0.0;            ///< t or week
    std::filesystem::path file; ///< of a real surface: the measure is taken of it and of the run's surface alike
    study::RealSurfaceOptions reading;
    std::optional<double> value; ///< what was observed; none: only predicted
    double sd = 0.0;             ///< of the observation, > 0 where there is one

    std::string name() const; ///< "gi_hull@t=0.5", "area_mm2@week=28", with the name of a file before it
};

/// The [[target]] and [[predict]] tables. Real surfaces are read and measured.
/// @param base  of which clock and duration decide what can be predicted
/// @throws InputError
std::vector<Quantity> read_targets(const config::TomlNode& list, const sweep::SweepPlace& place,
                                   const config::Options& base);
std::vector<Quantity> read_predictions(const config::TomlNode& list, const sweep::SweepPlace& place,
                                       const config::Options& base);

/// A measure written as in a sweep: "KEY" or "KEY@T".
Quantity parse_quantity(const std::string& text, const std::string& where, const config::Options& base);

/// Those numbers of a finished run; NaN where it has none. @throws InputError for a run folder that cannot be read
std::vector<double> predicted_by(const std::filesystem::path& run_folder, std::span<const Quantity> quantities);

} // namespace corticle::fit

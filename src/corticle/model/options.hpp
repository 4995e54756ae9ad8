// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/dynamics/options.hpp"
#include "corticle/material/clock.hpp"
#include "corticle/material/options.hpp"
#include "corticle/material/size.hpp"
#include "corticle/mechanics/boundary/options.hpp"
#include "corticle/mechanics/contact/options.hpp"
#include "corticle/mechanics/thesis/options.hpp"
#include "corticle/mechanics/tlsph/options.hpp"
#include "corticle/mechanics/tracts/options.hpp"

#include <optional>
#include <vector>

namespace corticle::model
{

/// How a body is cut up.
enum class Method
{
    tlsph, ///< particles
    fem    ///< linear tetrahedra
};

struct TimeOptions
{
    double start = 0.0; ///< growth time t of the body as it is given
    double end = 1.0;   ///< growth time t at which the run ends
    material::GestationalClock clock =
        material::GestationalClock::none; ///< with one, the weeks below set start and end
    std::optional<double> start_week;     ///< gestational age of the body as it is given
    std::optional<double> end_week;       ///< gestational age at which the run ends
};

/// What a simulation of a given body needs to know.
struct SimulationOptions
{
    Method method = Method::tlsph; ///< key solver.method
    material::TissueOptions tissue;
    thesis::Formulation formulation = thesis::Formulation::corrected; ///< key solver.formulation
    tlsph::TlsphOptions tlsph;                                        ///< keys under [solver]
    thesis::ThesisOptions thesis;                                     ///< where formulation = "thesis"
    contact::ContactOptions contact;                                  ///< keys under [contact]
    std::vector<boundary::SupportOptions> supports;                   ///< keys under [[support]]
    boundary::BoundaryOptions boundary;                               ///< keys under [boundary]
    tracts::TractOptions tracts;                                      ///< keys under [tracts]
    dynamics::DynamicsOptions dynamics;                               ///< keys under [solver]
    TimeOptions time;
    material::SizeOptions size;
};

/// Times of growth closer than this are the same output time.
inline constexpr double same_output_time = 1e-9;

/// The size by which the cortex thins, if it does.
inline material::ReferenceSize cortex_size(const SimulationOptions& options)
{
    return {options.time.clock, options.size.thin_cortex ? options.size.law : material::LengthLaw::none,
            options.time.start_week.value_or(0.0)};
}

} // namespace corticle::model

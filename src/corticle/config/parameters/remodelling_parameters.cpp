// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/remodelling_parameters.hpp"

#include "corticle/config/parameters/parameter_builders.hpp"

namespace corticle::config
{

using namespace detail;

#define CORTICLE_MEMBER(path) ([](auto& options) -> auto& { return options.tissue.remodelling.path; })

namespace
{

bool has_fibres(const Options& options)
{
    return options.tissue.remodelling.has_fibres();
}
bool has_tension(const Options& options)
{
    return options.tissue.remodelling.has_fibres() && options.tissue.remodelling.fibres.active_stress > 0.0;
}
bool has_growing_fibres(const Options& options)
{
    return options.tissue.remodelling.has_fibres() && options.tissue.remodelling.fibres.growth_rate > 0.0;
}
bool relaxes(const Options& options)
{
    return options.tissue.remodelling.relaxation.share > 0.0;
}
bool grows_by_stress(const Options& options)
{
    return options.tissue.remodelling.stress_growth.rate > 0.0;
}

} // namespace

std::vector<Parameter> remodelling_parameters()
{
    return {
        parameter(
            "fibres.direction", "", {},
            "Which way fibres of the white matter run: away from the centroid of the body, along the gradient of the "
            "distance to the surface, or as fibres.file says.",
            CORTICLE_MEMBER(fibres.direction)),
        path(
            "fibres.file",
            "NIfTI volume of vectors, three numbers a voxel along x, y and z of the scanner, in the coordinates of the "
            "body; their length and sign do not matter, 0 is no fibre.",
            [](auto& options) -> auto& { return options.fibre_file; }),
        where(has_fibres, parameter("fibres.stiffness", "mu", between(0.0, 100.0),
                                    "Stiffness of stretched fibres, in shear moduli of the tissue; compressed, they "
                                    "carry nothing.",
                                    CORTICLE_MEMBER(fibres.stiffness))),
        where(has_fibres, parameter("fibres.active_stress", "mu", between(0.0, 10.0),
                                    "Tension of the fibres at any length, in shear moduli of the tissue.",
                                    CORTICLE_MEMBER(fibres.active_stress))),
        where(has_tension, parameter("fibres.ramp", "t, or weeks with a clock", between(0.0, 100.0),
                                     "Time from the start in which that tension rises.", CORTICLE_MEMBER(fibres.ramp))),
        where(has_fibres, parameter("fibres.growth_rate", "1/t, or 1/weeks with a clock", between(0.0, 1000.0),
                                    "Rate at which the rest length of the fibres grows, per elastic stretch above "
                                    "growth_stretch.",
                                    CORTICLE_MEMBER(fibres.growth_rate))),
        where(has_growing_fibres,
              parameter("fibres.growth_stretch", "", between(0.5, 2.0), "Elastic stretch above which fibres grow.",
                        CORTICLE_MEMBER(fibres.growth_stretch))),
        parameter("relaxation.share", "", between(0.0, 0.95),
                  "Share of the shear modulus that relaxes, one Maxwell branch; 0: the tissue is elastic.",
                  CORTICLE_MEMBER(relaxation.share)),
        where(relaxes,
              parameter("relaxation.time", "t, or weeks with a clock", above(0.0, 10000.0),
                        "Time in which the stress of that branch falls to 1/e.", CORTICLE_MEMBER(relaxation.time))),
        parameter("stress_growth.rate", "1/t, or 1/weeks with a clock", between(0.0, 1000.0),
                  "Rate at which the volume of white matter grows, per elastic volume ratio above volume_ratio; 0: it "
                  "does not grow by stress.",
                  CORTICLE_MEMBER(stress_growth.rate)),
        where(grows_by_stress, parameter("stress_growth.volume_ratio", "", between(0.5, 2.0),
                                         "Elastic volume ratio above which white matter grows.",
                                         CORTICLE_MEMBER(stress_growth.volume_ratio))),
        where(grows_by_stress,
              parameter("stress_growth.shrinks", "", {}, "Whether it shrinks below that ratio at the same rate.",
                        CORTICLE_MEMBER(stress_growth.shrinks))),
    };
}

#undef CORTICLE_MEMBER

void use_remodelling(Options& options)
{
    material::RemodellingOptions& remodelling = options.tissue.remodelling;
    remodelling.fibres.direction = material::FibreField::radial;
    remodelling.fibres.active_stress = 1.0;
    remodelling.fibres.growth_rate = 1.0;
    remodelling.relaxation.share = 0.5;
    remodelling.stress_growth.rate = 1.0;
    options.map.protomap_amplitude = 1.0;
}

} // namespace corticle::config

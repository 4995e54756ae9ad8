// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/methods_text.hpp"

#include "corticle/report/plain_text.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle::report
{

namespace
{

using config::Options;

/// Works that the sentences cite, numbered in the order in which they are cited first.
class References
{
  public:
    std::string cite(std::string_view work)
    {
        std::size_t number = 0;
        while (number < works_.size() && works_[number] != work)
        {
            ++number;
        }
        if (number == works_.size())
        {
            works_.emplace_back(work);
        }
        return fmt::format("[{}]", number + 1);
    }
    const std::vector<std::string>& works() const { return works_; }

  private:
    std::vector<std::string> works_;
};

constexpr std::string_view tallinen =
    "T. Tallinen, J. Y. Chung, F. Rousseau, N. Girard, J. Lefèvre, L. Mahadevan: On the growth and form of cortical "
    "convolutions. Nature Physics 12 (2016) 588-593.";
constexpr std::string_view bonet =
    "J. Bonet, T.-S. L. Lok: Variational and momentum preservation aspects of Smooth Particle Hydrodynamic "
    "formulations. Computer Methods in Applied Mechanics and Engineering 180 (1999).";
constexpr std::string_view ganzenmueller =
    "G. C. Ganzenmüller: An hourglass control algorithm for Lagrangian Smooth Particle Hydrodynamics. Computer Methods "
    "in Applied Mechanics and Engineering 286 (2015).";
constexpr std::string_view nodal_averages =
    "J. Bonet, H. Marriott, O. Hassan: An averaged nodal deformation gradient linear tetrahedral element for large "
    "strain explicit dynamic applications. Communications in Numerical Methods in Engineering 17 (2001).";
constexpr std::string_view barrier =
    "M. Li et al.: Incremental Potential Contact: intersection- and inversion-free, large-deformation dynamics. ACM "
    "Transactions on Graphics 39 (2020).";
constexpr std::string_view wendland =
    "H. Wendland: Piecewise polynomial, positive definite and compactly supported radial functions of minimal degree. "
    "Advances in Computational Mathematics 4 (1995).";

std::string geometry_text(const Options& options, const Json& summary)
{
    const prepare::GeometryOptions& geometry = options.geometry;
    std::string body;
    switch (geometry.shape)
    {
    case prepare::Shape::sphere:
        body = fmt::format("a sphere of radius {:.4g} mm", geometry.radius_mm);
        break;
    case prepare::Shape::ellipsoid:
        body = fmt::format("an ellipsoid with semi-axes of {:.4g}, {:.4g} and {:.4g} mm", geometry.semi_axes_mm[0],
                           geometry.semi_axes_mm[1], geometry.semi_axes_mm[2]);
        break;
    case prepare::Shape::box:
        body = fmt::format("a box of {:.4g} by {:.4g} by {:.4g} mm with cortex below its highest face",
                           geometry.size_mm[0], geometry.size_mm[1], geometry.size_mm[2]);
        break;
    case prepare::Shape::file:
        body = fmt::format("the body in {}", name_of(geometry.file));
        break;
    }
    std::string text = fmt::format("The initial body is {}.", body);
    const double amplitude = prepare::imperfection_amplitude(options);
    if (amplitude > 0.0)
    {
        text += fmt::format(" Growth varies over it by a seeded smooth random field of relative amplitude {:.3g} "
                            "(seed {}).",
                            amplitude, options.imperfection.seed);
    }
    if (options.time.clock != material::GestationalClock::none && options.time.start_week && options.time.end_week)
    {
        text += fmt::format(" The run covers gestational weeks {:.4g} to {:.4g}.", *options.time.start_week,
                            *options.time.end_week);
    }
    else
    {
        text += fmt::format(" Growth time runs from t = {:.4g} to {:.4g}.", options.time.start,
                            summary.value("t", options.time.end));
    }
    return text;
}

std::string tissue_text(const Options& options, References& references)
{
    const material::TissueOptions& tissue = options.tissue;
    std::string text = fmt::format(
        "Cortex and white matter are compressible neo-Hookean solids with shear moduli of {:.4g} and {:.4g} (in units "
        "of that of the white matter) and a bulk modulus of {:.4g}{}. ",
        tissue.mu_cortex, tissue.mu_white, tissue.bulk_modulus,
        tissue.bulk == material::BulkRule::per_tissue ? " times the shear modulus" : "");
    text += fmt::format("Growth is a multiplicative split of the deformation gradient: the cortex grows in its plane "
                        "by g = 1 + {:.4g} θ t {}, where θ is the share of cortex",
                        tissue.alpha_t, references.cite(tallinen));
    text += tissue.alpha_r > 0.0 ? fmt::format(", and along its normal by 1 + {:.4g} θ t", tissue.alpha_r) : "";
    text += tissue.alpha_white > 0.0 ? fmt::format("; the white matter grows by 1 + {:.4g} t", tissue.alpha_white) : "";
    text += fmt::format(". The boundary of the cortex is {}.",
                        tissue.layer == material::Layer::smooth ? "smooth" : "sharp");
    if (tissue.lambda > 0.0)
    {
        return text + fmt::format(" The cortex is what lies outside the similar body of {:.4g} of the squared radius.",
                                  tissue.lambda);
    }
    return text + (options.map.thickness_file.empty()
                       ? fmt::format(" It is {:.4g} mm thick at t = 0.", tissue.thickness_mm)
                       : std::string(" Its thickness is that of a map."));
}

std::string method_text(const Options& options, const Json& summary, References& references)
{
    const double spacing = summary.value("spacing_mm", 0.0);
    std::string text;
    if (options.method == model::Method::fem)
    {
        text = fmt::format("The equations of motion are solved on {} linear tetrahedra with nodal averages of the "
                           "volume ratio {}.",
                           summary.value("elements", 0), references.cite(nodal_averages));
    }
    else if (options.formulation == thesis::Formulation::thesis)
    {
        text = fmt::format("The equations of motion are solved with Smooth Particle Hydrodynamics in the formulation "
                           "of the thesis, with {} particles.",
                           summary.value("particles", 0));
    }
    else
    {
        text = fmt::format("The equations of motion are solved with Total-Lagrangian Smooth Particle Hydrodynamics "
                           "{} with {} particles at a spacing of {:.3g} mm, Wendland's C2 kernel {} with a support of "
                           "{:.3g} spacings, gradients of second order near the surface, and hourglass control {} of "
                           "strength {:.3g}.",
                           references.cite(bonet), summary.value("particles", 0), spacing, references.cite(wendland),
                           options.tlsph.support, references.cite(ganzenmueller), options.tlsph.zeta);
    }
    text += fmt::format(" Time is integrated explicitly with damping of {:.3g} per unit of growth time, so that the "
                        "body stays near equilibrium.",
                        options.dynamics.damping);
    if (options.contact.enabled)
    {
        text += fmt::format(" Parts of the surface that meet are kept apart by a barrier potential {} within {:.3g} "
                            "spacings and a limit on their travel.",
                            references.cite(barrier), options.contact.distance);
    }
    return text;
}

std::string program_text(const Json& summary)
{
    std::string text =
        fmt::format("Corticle {} took {} steps", summary.value("version", std::string("(version unknown)")),
                    summary.value("steps", 0));
    const Json error = summary.value("energy_balance_error", Json(nullptr));
    if (error.is_number())
    {
        text += fmt::format("; the energy balance closes to {:.2g} %", 100.0 * std::abs(error.get<double>()));
    }
    const Json onset = summary.value("onset_t", Json(nullptr));
    if (onset.is_number())
    {
        text += fmt::format("; folds appear at growth time {:.3g}", onset.get<double>());
    }
    return text + ".";
}

} // namespace

Json methods_text(const Options& options, const Json& summary)
{
    References references;
    Json paragraphs = Json::array();
    paragraphs.push_back(geometry_text(options, summary));
    paragraphs.push_back(tissue_text(options, references));
    paragraphs.push_back(method_text(options, summary, references));
    paragraphs.push_back(program_text(summary));
    return {{"paragraphs", std::move(paragraphs)}, {"references", references.works()}};
}

} // namespace corticle::report

// SPDX-License-Identifier: GPL-3.0-or-later
// The laws in a kernel: compiled by check_device_headers.py, never run.
#if defined(__CUDA__) && !defined(__CUDACC__)
// clang without the headers of CUDA: what these give the laws.
#define __global__ __attribute__((global))
#define __device__ __attribute__((device))
#define __host__ __attribute__((host))
#include <cmath>
namespace std
{
__device__ double sqrt(double);
__device__ double log(double);
} // namespace std
#endif

#include "corticle/material/neo_hookean.hpp"
#include "corticle/material/remodelled.hpp"
#include "corticle/mechanics/tlsph/fit.hpp"
#include "corticle/mechanics/tlsph/particle_law.hpp"

namespace corticle
{

template <class Real>
struct Particle
{
    Real theta;
    BasicVec3<Real> normal;
    Real volume;
    tlsph::BasicEnrichedTerms<Real> sum;
    BasicVec3<Real> X;
    BasicVec3<Real> x;
    BasicVec3<Real> weighted_sum;
    FixedArray<Real, 6> second_moment;
    tlsph::Fit<Real, tlsph::quadratic_functions> fit;
    typename tlsph::Fit<Real, tlsph::quadratic_functions>::Vectors pulls;
    tlsph::ParticleResponse<Real> response;
};

template <class Real>
__global__ void respond_on_device(material::TissueOptions tissue, double t, Particle<Real>* particles)
{
    Particle<Real>& particle = particles[0];
    const auto point = material::material_point(tissue, particle.theta, broadcast<Real>(1.0), t);
    const auto sums = tlsph::deformation_sums(particle.sum.linear, particle.X, particle.x, particle.weighted_sum);
    const auto products = tlsph::product_moments(particle.sum, particle.X, particle.x, particle.second_moment);
    for (int k = 0; k < 3; ++k)
    {
        particle.fit.moments[k] = sums.moment.column[k];
    }
    for (int k = 0; k < 6; ++k)
    {
        particle.fit.moments[3 + k] = products[k];
    }
    const auto coefficients = particle.fit.coefficients();
    const auto deformation = tlsph::particle_deformation(particle.fit.gradient(coefficients));
    particle.response =
        tlsph::particle_response<false>(material::NeoHookean{tissue.barrier_J}, point, particle.normal, particle.volume,
                                        0.02, deformation, particle.fit.residual(coefficients));
    particle.pulls = particle.fit.pulls(particle.response.stress, particle.response.zeta);
}
/// The same with a history, which goes on by a step.
template <class Real>
struct RemodelledParticle
{
    material::BasicMaterialPoint<Real> point;
    BasicVec3<Real> normal;
    BasicMat3<Real> F;
    material::BasicFibre<Real> fibre;
    material::BasicPointHistory<Real> history;
    material::BasicResponse<Real> response;
};

template <class Real>
__global__ void remodel_on_device(material::RemodellingStep step, double barrier_J, RemodelledParticle<Real>* particles)
{
    RemodelledParticle<Real>& p = particles[0];
    p.history.growth =
        material::growth_by_stress(step, p.point, p.fibre.share, determinant(p.F), p.history.growth);
    const auto grown = material::grown_by_stress(p.point, p.history.growth);
    p.history = material::advanced(step, p.fibre, material::elastic_deformation(grown, p.normal, p.F), p.history);
    const auto law = material::remodelled(step, step.tension, material::NeoHookean{barrier_J}, p.fibre, p.history);
    p.response = material::respond(law, grown, p.normal, p.F);
}
template __global__ void remodel_on_device(material::RemodellingStep, double, RemodelledParticle<double>*);
template __global__ void remodel_on_device(material::RemodellingStep, double, RemodelledParticle<float>*);

template __global__ void respond_on_device(material::TissueOptions, double, Particle<double>*);
template __global__ void respond_on_device(material::TissueOptions, double, Particle<float>*);

} // namespace corticle

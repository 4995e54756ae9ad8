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
#include "corticle/mechanics/tlsph/particle_law.hpp"

namespace corticle
{

template <class Real>
struct Particle
{
    Real theta;
    BasicVec3<Real> normal;
    tlsph::ParticleReference<Real> reference;
    tlsph::DeformationSums<Real> sums;
    BasicVec3<Real> X;
    BasicVec3<Real> x;
    tlsph::BasicEnrichedTerms<Real> enriched_sums;
    BasicVec3<Real> enriched_moment;
    BasicMat3<Real> Q;
    tlsph::ParticleResponse<Real> response;
};

template <class Real>
__global__ void respond_on_device(material::TissueOptions tissue, double t, Particle<Real>* particles)
{
    Particle<Real>& particle = particles[0];
    const auto point = material::material_point(tissue, particle.theta, broadcast<Real>(1.0), t);
    const auto linear_F = particle.sums.moment * particle.reference.correction;
    const auto products = tlsph::enriched_moment(particle.enriched_sums, particle.X, particle.x, particle.normal,
                                                 particle.enriched_moment);
    const auto F = particle.sums.moment * transpose(particle.reference.gradient) + products * transpose(particle.Q);
    const auto deformation = tlsph::particle_deformation(F, linear_F);
    particle.response = tlsph::particle_response<false>(material::NeoHookean{tissue.barrier_J}, point, particle.normal,
                                                 particle.reference, particle.sums, deformation);
}
template __global__ void respond_on_device(material::TissueOptions, double, Particle<double>*);
template __global__ void respond_on_device(material::TissueOptions, double, Particle<float>*);

} // namespace corticle

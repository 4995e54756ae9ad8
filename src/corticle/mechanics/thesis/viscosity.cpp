// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/thesis/viscosity.hpp"

#include "corticle/base/parallel.hpp"

#include <algorithm>

namespace corticle::thesis
{

ArtificialViscosity::ArtificialViscosity(const ThesisOptions& options, std::span<const double> wave_speeds, double h,
                                         const Vec3& origin)
    : law_{static_cast<float>(options.viscosity_alpha), static_cast<float>(options.viscosity_beta),
           static_cast<float>(h)},
      origin_(origin), records_(wave_speeds.size())
{
    for (std::size_t i = 0; i < records_.size(); ++i)
    {
        records_[i].half_speed = static_cast<float>(0.5 * wave_speeds[i]);
    }
}

CORTICLE_EVERY_ISA void ArtificialViscosity::add_block(const Law& law, const NeighborGroups& groups,
                                                       const Record* records, std::int64_t begin, std::int64_t end,
                                                       Vec3* forces, double& power)
{
    constexpr std::int64_t size = NeighborGroups::size;
    const float softening = 0.01F * law.h * law.h;
    const FloatOctet zero{};
    for (std::int64_t first = begin; first < end; first += size)
    {
        const std::int64_t lanes = std::min(size, end - first);
        FloatOctet x_i[3] = {};
        FloatOctet v_i[3] = {};
        FloatOctet X_i[3] = {};
        FloatOctet c_i = {};
        for (std::int64_t lane = 0; lane < lanes; ++lane)
        {
            const Record& own = records[first + lane];
            for (int axis = 0; axis < 3; ++axis)
            {
                x_i[axis][lane] = own.x[axis];
                v_i[axis][lane] = own.v[axis];
                X_i[axis][lane] = own.X[axis];
            }
            c_i[lane] = own.half_speed;
        }
        FloatOctet sum[3] = {};
        for (std::int64_t k = groups.begin[first / size]; k < groups.begin[first / size + 1]; ++k)
        {
            const Record& other = records[groups.index[k]];
            FloatOctet approach = zero;
            FloatOctet squared_distance = zero;
            for (int axis = 0; axis < 3; ++axis)
            {
                const FloatOctet x_ij = other.x[axis] - x_i[axis];
                approach += (other.v[axis] - v_i[axis]) * x_ij;
                squared_distance += x_ij * x_ij;
            }
            const FloatOctet phi = law.h * (approach < zero ? approach : zero) / (squared_distance + softening);
            FloatOctet weighted;
            groups.get_weights(k, weighted);
            weighted *= phi * (law.beta * phi - law.alpha * (c_i + other.half_speed));
            for (int axis = 0; axis < 3; ++axis)
            {
                sum[axis] += weighted * (other.X[axis] - X_i[axis]);
            }
        }
        for (std::int64_t lane = 0; lane < lanes; ++lane)
        {
            const Record& own = records[first + lane];
            const Vec3 force{-sum[0][lane], -sum[1][lane], -sum[2][lane]};
            forces[first + lane] += force;
            power -= dot(force, {own.v[0], own.v[1], own.v[2]});
        }
    }
}

double ArtificialViscosity::add_forces(const NeighborGroups& groups, std::span<const Vec3> X, std::span<const Vec3> x,
                                       std::span<const Vec3> v, std::span<Vec3> forces)
{
    parallel_for(std::ssize(x),
                 [&](std::int64_t i)
                 {
                     Record& record = records_[i];
                     for (int axis = 0; axis < 3; ++axis)
                     {
                         record.x[axis] = static_cast<float>(x[i][axis] - origin_[axis]);
                         record.v[axis] = static_cast<float>(v[i][axis]);
                         record.X[axis] = static_cast<float>(X[i][axis] - origin_[axis]);
                     }
                 });
    return parallel_reduce(
        std::ssize(x), 0.0,
        [&](std::int64_t begin, std::int64_t end)
        {
            double power = 0.0;
            add_block(law_, groups, records_.data(), begin, end, forces.data(), power);
            return power;
        },
        [](double& total, double part) { total += part; });
}

} // namespace corticle::thesis

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/solver.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/base/simd.hpp"
#include "corticle/material/tissue_law.hpp"
#include "corticle/mechanics/fem/force_pass.hpp"
#include "corticle/mechanics/fem/remodelled_pass.hpp"
#include "corticle/mesh/sizes.hpp"

#include <fmt/format.h>

#include <limits>

namespace corticle::fem
{

namespace
{

/// Sum of the parts of a node, each four doubles.
template <class Part>
CORTICLE_INLINE Part joined(const TetElements& elements, std::int64_t node, const Part* parts)
{
    Lanes sum{};
    for (std::int64_t k = elements.part_begin[node]; k < elements.part_begin[node + 1]; ++k)
    {
        sum += reinterpret_cast<const Lanes&>(parts[elements.part[k]]);
    }
    Part result;
    reinterpret_cast<Lanes&>(result) = sum;
    return result;
}

} // namespace

FemSolver::FemSolver(const TetElements& elements, const material::Tissue& tissue)
    : FemSolver(elements, tissue,
                tissue.remodelling == nullptr ? force_pass(material::tissue_law(tissue.options))
                                              : remodelled_force_pass(tissue.options))
{
}

FemSolver::FemSolver(const TetElements& elements, const material::Tissue& tissue,
                     std::unique_ptr<const ForcePass> forces)
    : elements_(elements), tissue_(tissue), force_pass_(std::move(forces)), volume_parts_(elements.chunk_node.size()),
      force_parts_(elements.chunk_node.size()), node_values_(elements.X.size())
{
}

FemSolver::~FemSolver() = default;

mechanics::InternalResponse FemSolver::evaluate_volumes(std::span<const Vec3> x, double t)
{
    const auto sum_chunk = tissue_.remodelling != nullptr ? remodelled_volumes
                           : tissue_.grows_plainly()      ? plain_volumes
                                                          : general_volumes;
    parallel_blocks(std::ssize(elements_.tets),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        const Chunk chunk(elements_, tissue_, t, begin, end);
                        sum_chunk(chunk, x.data(), volume_parts_.data() + chunk.first_part);
                    });
    const double barrier_J = force_pass_->barrier_J();
    return parallel_reduce(
        std::ssize(x), mechanics::InternalResponse{},
        [&](std::int64_t begin, std::int64_t end)
        {
            mechanics::InternalResponse sum;
            for (std::int64_t i = begin; i < end; ++i)
            {
                const NodalVolume volume = joined(elements_, i, volume_parts_.data());
                const double ratio = volume.current / volume.grown;
                if (!std::isfinite(ratio) || (ratio <= 0.0 && barrier_J > 0.0))
                {
                    sum.invalid_at = sum.invalid_at < 0 ? i : sum.invalid_at;
                    continue;
                }
                const auto [density, slope] = force_pass_->respond_to_volume(ratio);
                const double pressure = volume.bulk / volume.grown * slope;
                node_values_[i] = {pressure, density, pressure * ratio};
                sum.elastic_energy += volume.bulk * density;
                sum.barrier_count += ratio < barrier_J && barrier_J > 0.0 ? 1 : 0;
            }
            return sum;
        },
        mechanics::join);
}

mechanics::InternalResponse FemSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    require_size("positions", x.size(), elements_.X.size());
    require_size("forces", forces.size(), elements_.X.size());
    mechanics::InternalResponse total = evaluate_volumes(x, t);
    if (total.invalid_at >= 0)
    {
        return total;
    }
    mechanics::InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    total.smallest_J = initial.smallest_J;
    mechanics::join(total, parallel_reduce(
                               std::ssize(elements_.tets), initial,
                               [&](std::int64_t begin, std::int64_t end)
                               {
                                   const Chunk chunk(elements_, tissue_, t, begin, end);
                                   mechanics::InternalResponse sum = initial;
                                   force_pass_->run(chunk, x.data(), node_values_.data(),
                                                    force_parts_.data() + chunk.first_part, sum);
                                   return sum;
                               },
                               mechanics::join));
    // The square of the largest frequency is at most the largest mean, over the tets of a node and weighted with their
    // volume, of the largest of each tet, 4 stiffness / V. A rate of one spacing per step that is just stable is half
    // of the frequency.
    const double squared_rate = parallel_reduce(
        std::ssize(x), 0.0,
        [&](std::int64_t begin, std::int64_t end)
        {
            double largest = 0.0;
            for (std::int64_t i = begin; i < end; ++i)
            {
                Vec3 force = joined(elements_, i, force_parts_.data());
                largest = std::max(largest, force.lane / elements_.node_volume[i]);
                force.lane = 0.0;
                forces[i] = force;
            }
            return largest;
        },
        [](double& largest, double part) { largest = std::max(largest, part); });
    total.stiffest_rate = 0.5 * elements_.spacing * std::sqrt(squared_rate);
    if (!std::isfinite(total.elastic_energy + squared_rate))
    {
        const auto broken = std::ranges::find_if_not(forces, is_finite);
        total.invalid_at = broken == forces.end() ? 0 : broken - forces.begin();
    }
    return total;
}

std::vector<Mat3> FemSolver::deformation_gradients(std::span<const Vec3> x) const
{
    require_size("positions", x.size(), elements_.X.size());
    std::vector<Mat3> F(x.size());
    for (std::size_t e = 0; e < elements_.tets.size(); ++e)
    {
        const Mat3 share = (0.25 * elements_.volume[e]) * deformation_gradient(elements_, e, x);
        for (const std::int32_t node : elements_.tets[e])
        {
            F[node] += share;
        }
    }
    for (std::size_t i = 0; i < F.size(); ++i)
    {
        F[i] = (1.0 / elements_.node_volume[i]) * F[i];
    }
    return F;
}

std::string FemSolver::diagnosis(std::int64_t node, std::span<const Vec3> x) const
{
    std::size_t worst = 0;
    double smallest_J = std::numeric_limits<double>::infinity();
    for (std::size_t e = 0; e < elements_.tets.size(); ++e)
    {
        if (std::ranges::find(elements_.tets[e], node) != elements_.tets[e].end())
        {
            const double J = determinant(deformation_gradient(elements_, e, x));
            if (!(J >= smallest_J)) // NaN is the worst
            {
                worst = e;
                smallest_J = J;
            }
        }
    }
    const Tet& corners = elements_.tets[worst];
    const std::span<const Tet> tet(&corners, 1);
    return fmt::format(
        "element {}: {}, corners {}, {}, {}, {}; volume of node {} now {:.4g} mm³, at rest {:.4g} mm³", worst,
        mechanics::describe_point(centroids(x, tet)[0], centroids(elements_.X, tet)[0], tissue_.fields.depth[worst],
                                  deformation_gradient(elements_, worst, x)),
        corners[0], corners[1], corners[2], corners[3], node,
        node_volumes({{x.begin(), x.end()}, elements_.tets})[node], elements_.node_volume[node]);
}

} // namespace corticle::fem

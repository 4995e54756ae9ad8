// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/fem/solver.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/fem/block_law.hpp"
#include "corticle/fem/extrapolation.hpp"

#include <fmt/format.h>

#include <limits>

namespace corticle
{

namespace
{

/// One chunk of tets, with its part of the buffers.
struct Chunk
{
    const TetElements& elements;
    const Tissue& tissue;
    double t;
    std::int64_t begin, end;             ///< tets
    std::span<const std::int32_t> nodes; ///< that it touches
    std::int64_t first_part;             ///< where their parts start

    Chunk(const TetElements& all, const Tissue& of_tets, double now, std::int64_t first, std::int64_t last)
        : elements(all), tissue(of_tets), t(now), begin(first), end(last)
    {
        const std::int64_t c = first / parallel_block;
        first_part = all.chunk_begin[c];
        nodes = std::span(all.chunk_node).subspan(first_part, all.chunk_begin[c + 1] - first_part);
    }

    const TetBlock& block_of(std::int64_t first) const { return elements.blocks[first / lane_count]; }
    int lanes_from(std::int64_t first) const
    {
        return static_cast<int>(std::min<std::int64_t>(lane_count, end - first));
    }
};

constexpr std::size_t most_nodes = 4 * parallel_block;

/// Indices of the tets of a block; lanes past the last tet repeat it.
CORTICLE_INLINE void tet_indices(const Chunk& chunk, std::int64_t first, std::size_t (&tet)[lane_count])
{
    for (int l = 0; l < lane_count; ++l)
    {
        tet[l] = static_cast<std::size_t>(std::min(first + l, chunk.end - 1));
    }
}

/// `plain`: growth is that of Tissue::grows_plainly. @param F  see general_material
template <bool plain>
CORTICLE_INLINE void fill_material(const Chunk& chunk, std::int64_t first, const Mat3* F, BlockMaterial& material)
{
    std::size_t tet[lane_count];
    tet_indices(chunk, first, tet);
    if constexpr (plain)
    {
        plain_material(chunk.tissue, tet, chunk.t, material);
    }
    else
    {
        general_material(chunk.tissue, tet, chunk.t, F, material);
    }
}

template <bool plain>
CORTICLE_INLINE void sum_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    Lanes local[most_nodes];
    for (std::size_t k = 0; k < chunk.nodes.size(); ++k)
    {
        local[k] = lanes(x[chunk.nodes[k]]);
        parts[k] = {};
    }
    alignas(64) LaneValues edge[9];
    BlockMaterial material;
    BlockVolumes volumes;
    for (std::int64_t first = chunk.begin; first < chunk.end; first += lane_count)
    {
        const TetBlock& block = chunk.block_of(first);
        gather_edges(block, local, edge);
        fill_material<plain>(chunk, first, nullptr, material); // volumes do not know the normal
        block_volumes(block, edge, material, volumes);
        for (int l = 0; l < chunk.lanes_from(first); ++l)
        {
            const Lanes share = 0.25 * Lanes{volumes.current[l], volumes.grown[l], volumes.bulk[l], 0.0};
            for (const auto& corner : block.corner)
            {
                reinterpret_cast<Lanes&>(parts[corner[l]]) += share;
            }
        }
    }
}

Mat3 gradient_in_lane(const TetBlock& block, const LaneValues* edge, int l)
{
    Mat3 F;
    for (int k = 0; k < 9; ++k)
    {
        F(k / 3, k % 3) = edge[k / 3][l] * block.inverse_edges[k % 3][l] +
                          edge[3 + k / 3][l] * block.inverse_edges[3 + k % 3][l] +
                          edge[6 + k / 3][l] * block.inverse_edges[6 + k % 3][l];
    }
    return F;
}

/// Adds what the volumetric part of a tet does to what its deviatoric part does, where that is extrapolated.
/// False where it is not.
bool extrapolate(const TetBlock& block, const LaneValues* edge, const BlockMaterial& m, const BlockNodal& nodal, int l,
                 BlockResponse& out)
{
    const Mat3 F = gradient_in_lane(block, edge, l);
    const double g = m.growth[l];
    const double g_r = m.radial_growth[l];
    const Vec3 n{m.normal[0][l], m.normal[1][l], m.normal[2][l]};
    const Mat3 inverse_G = inverse_growth_tensor(g, n, g_r);
    const Mat3 F_e = F * inverse_G;
    const SingularValues elastic = singular_values(F_e);
    if (!(elastic.stretch.z < extrapolated_stretch))
    {
        return false;
    }
    const auto [shear_energy, bulk_energy, stress] =
        extrapolated_deviatoric(elastic, m.shear_modulus[l], m.bulk_modulus[l]);
    const double grown = block.volume[l] * g * g * g_r;
    const Mat3 P = grown * (stress * inverse_G) + (0.25 * nodal.pressure[l] * block.volume[l]) * cofactor(F);
    double squared_gradients = 0.0;
    Vec3 sum;
    for (int a = 0; a < 3; ++a)
    {
        const Vec3 B{block.inverse_edges[3 * a][l], block.inverse_edges[3 * a + 1][l],
                     block.inverse_edges[3 * a + 2][l]};
        const Vec3 force = -(P * B);
        out.force[3 * a][l] = force.x;
        out.force[3 * a + 1][l] = force.y;
        out.force[3 * a + 2][l] = force.z;
        squared_gradients += squared_norm(B);
        sum += B;
    }
    squared_gradients += squared_norm(sum);
    const double growth = m.growth_rate[l] / g;
    const double radial_growth = m.radial_growth_rate[l] / g_r;
    const double swelling = 2.0 * growth + radial_growth;
    const double energy = shear_energy + bulk_energy;
    const double radial = dot(stress * n, F_e * n);
    out.energy[l] = grown * energy;
    out.power[l] =
        grown *
        (swelling * energy - growth * (contract(stress, F_e) - radial) - radial_growth * radial +
         shear_energy * m.shear_rate[l] / m.shear_modulus[l] + bulk_energy * m.bulk_rate[l] / m.bulk_modulus[l] +
         0.25 * ((swelling * m.bulk_modulus[l] + m.bulk_rate[l]) * nodal.density[l] - swelling * nodal.work[l]));
    out.J[l] = determinant(F);
    // The tangent of the extrapolated law stays below about ten times that of the tissue at rest.
    constexpr double stiffening = 10.0;
    out.stiffness[l] = grown * stiffening * (m.bulk_modulus[l] + 4.0 / 3.0 * m.shear_modulus[l]) * squared_gradients;
    return true;
}

/// Reads the nodal values of the corners of a block.
CORTICLE_INLINE void gather_nodal(const TetBlock& block, const Lanes* local, BlockNodal& nodal)
{
    for (int l = 0; l < lane_count; ++l)
    {
        const auto& corner = block.corner;
        const Lanes sum = (local[corner[0][l]] + local[corner[1][l]]) + (local[corner[2][l]] + local[corner[3][l]]);
        nodal.pressure[l] = sum[0];
        nodal.density[l] = sum[1];
        nodal.work[l] = sum[2];
    }
}

CORTICLE_INLINE void scatter(const TetBlock& block, const BlockResponse& out, int l, Vec3* parts)
{
    const double stiffness = out.stiffness[l];
    const Lanes f1{out.force[0][l], out.force[1][l], out.force[2][l], stiffness};
    const Lanes f2{out.force[3][l], out.force[4][l], out.force[5][l], stiffness};
    const Lanes f3{out.force[6][l], out.force[7][l], out.force[8][l], stiffness};
    const Lanes f0 = Lanes{0.0, 0.0, 0.0, 4.0 * stiffness} - (f1 + f2 + f3);
    lanes(parts[block.corner[0][l]]) += f0;
    lanes(parts[block.corner[1][l]]) += f1;
    lanes(parts[block.corner[2][l]]) += f2;
    lanes(parts[block.corner[3][l]]) += f3;
}

template <bool plain>
CORTICLE_INLINE void sum_forces(const Chunk& chunk, const Vec3* x, const NodalPressure* node_values, Vec3* parts,
                                InternalResponse& sum)
{
    Lanes local[most_nodes];
    Lanes local_values[most_nodes];
    for (std::size_t k = 0; k < chunk.nodes.size(); ++k)
    {
        local[k] = lanes(x[chunk.nodes[k]]);
        local_values[k] = reinterpret_cast<const Lanes&>(node_values[chunk.nodes[k]]);
        parts[k] = {};
    }
    const bool current_normal = !plain && chunk.tissue.options.normal == NormalFrame::current;
    alignas(64) LaneValues edge[9];
    BlockMaterial material;
    BlockNodal nodal;
    BlockResponse out;
    for (std::int64_t first = chunk.begin; first < chunk.end; first += lane_count)
    {
        const TetBlock& block = chunk.block_of(first);
        gather_edges(block, local, edge);
        Mat3 F[lane_count];
        for (int l = 0; current_normal && l < lane_count; ++l)
        {
            F[l] = gradient_in_lane(block, edge, l);
        }
        fill_material<plain>(chunk, first, current_normal ? F : nullptr, material);
        gather_nodal(block, local_values, nodal);
        respond(block, edge, material, nodal, out);
        for (int l = 0; l < chunk.lanes_from(first); ++l)
        {
            if (!(out.flatness[l] > extrapolated_stretch))
            {
                sum.extrapolated_count += extrapolate(block, edge, material, nodal, l, out) ? 1 : 0;
                sum.inverted_count += out.J[l] <= 0.0 ? 1 : 0;
            }
            scatter(block, out, l, parts);
            sum.elastic_energy += out.energy[l];
            sum.growth_power += out.power[l];
            if (out.J[l] < sum.smallest_J)
            {
                sum.smallest_J = out.J[l];
                sum.smallest_J_at = first + l;
            }
        }
    }
}

CORTICLE_EVERY_ISA void plain_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    sum_volumes<true>(chunk, x, parts);
}
CORTICLE_EVERY_ISA void general_volumes(const Chunk& chunk, const Vec3* x, NodalVolume* parts)
{
    sum_volumes<false>(chunk, x, parts);
}
CORTICLE_EVERY_ISA void plain_forces(const Chunk& chunk, const Vec3* x, const NodalPressure* values, Vec3* parts,
                                     InternalResponse& sum)
{
    sum_forces<true>(chunk, x, values, parts, sum);
}
CORTICLE_EVERY_ISA void general_forces(const Chunk& chunk, const Vec3* x, const NodalPressure* values, Vec3* parts,
                                       InternalResponse& sum)
{
    sum_forces<false>(chunk, x, values, parts, sum);
}

void join(InternalResponse& total, const InternalResponse& part)
{
    total.elastic_energy += part.elastic_energy;
    total.growth_power += part.growth_power;
    total.barrier_count += part.barrier_count;
    total.extrapolated_count += part.extrapolated_count;
    total.inverted_count += part.inverted_count;
    total.stiffest_rate = std::max(total.stiffest_rate, part.stiffest_rate);
    if (part.smallest_J < total.smallest_J)
    {
        total.smallest_J = part.smallest_J;
        total.smallest_J_at = part.smallest_J_at;
    }
    total.invalid_at = total.invalid_at < 0 ? part.invalid_at : total.invalid_at;
}

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

FemSolver::FemSolver(const TetElements& elements, const Tissue& tissue)
    : elements_(elements), tissue_(tissue), volume_parts_(elements.chunk_node.size()),
      force_parts_(elements.chunk_node.size()), node_values_(elements.X.size())
{
}

InternalResponse FemSolver::evaluate_volumes(std::span<const Vec3> x, double t)
{
    const auto sum_chunk = tissue_.grows_plainly() ? plain_volumes : general_volumes;
    parallel_blocks(std::ssize(elements_.tets),
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        const Chunk chunk(elements_, tissue_, t, begin, end);
                        sum_chunk(chunk, x.data(), volume_parts_.data() + chunk.first_part);
                    });
    const double barrier_J = tissue_.options.barrier_J;
    return parallel_reduce(
        std::ssize(x), InternalResponse{},
        [&](std::int64_t begin, std::int64_t end)
        {
            InternalResponse sum;
            for (std::int64_t i = begin; i < end; ++i)
            {
                const NodalVolume volume = joined(elements_, i, volume_parts_.data());
                const double ratio = volume.current / volume.grown;
                const NeoHookean law{0.0, 1.0, barrier_J};
                if (!std::isfinite(ratio) || (ratio <= 0.0 && barrier_J > 0.0))
                {
                    sum.invalid_at = sum.invalid_at < 0 ? i : sum.invalid_at;
                    continue;
                }
                const auto [density, slope] = law.respond_to_volume(ratio);
                const double pressure = volume.bulk / volume.grown * slope;
                node_values_[i] = {pressure, density, pressure * ratio};
                sum.elastic_energy += volume.bulk * density;
                sum.barrier_count += ratio < barrier_J && barrier_J > 0.0 ? 1 : 0;
            }
            return sum;
        },
        join);
}

InternalResponse FemSolver::evaluate(std::span<const Vec3> x, double t, std::span<Vec3> forces)
{
    InternalResponse total = evaluate_volumes(x, t);
    if (total.invalid_at >= 0)
    {
        return total;
    }
    const auto sum_chunk = tissue_.grows_plainly() ? plain_forces : general_forces;
    InternalResponse initial;
    initial.smallest_J = std::numeric_limits<double>::infinity();
    total.smallest_J = initial.smallest_J;
    join(total, parallel_reduce(
                    std::ssize(elements_.tets), initial,
                    [&](std::int64_t begin, std::int64_t end)
                    {
                        const Chunk chunk(elements_, tissue_, t, begin, end);
                        InternalResponse sum = initial;
                        sum_chunk(chunk, x.data(), node_values_.data(), force_parts_.data() + chunk.first_part, sum);
                        return sum;
                    },
                    join));
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
            if (!(J >= smallest_J)) // one that is no number is the worst
            {
                worst = e;
                smallest_J = J;
            }
        }
    }
    const Tet& corners = elements_.tets[worst];
    const std::span<const Tet> tet(&corners, 1);
    return fmt::format("element {}: {}, corners {}, {}, {}, {}; volume of node {} now {:.4g} mm³, at rest {:.4g} mm³",
                       worst,
                       describe_point(centroids(x, tet)[0], centroids(elements_.X, tet)[0], tissue_.depth[worst],
                                      deformation_gradient(elements_, worst, x)),
                       corners[0], corners[1], corners[2], corners[3], node,
                       node_volumes({{x.begin(), x.end()}, elements_.tets})[node], elements_.node_volume[node]);
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/fem/passes.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/fem/block_law.hpp"
#include "corticle/fem/extrapolation.hpp"

namespace corticle
{

namespace
{

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

} // namespace

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

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/fem/passes.hpp"

#include "corticle/base/parallel.hpp"
#include "corticle/mechanics/fem/block_law.hpp"
#include "corticle/mechanics/fem/extrapolation.hpp"

#include <optional>

namespace corticle::fem
{

namespace
{

constexpr std::size_t most_nodes = 4 * parallel_block;

CORTICLE_INLINE WideGroup group_of(const Chunk& chunk, std::int64_t first)
{
    return {first, std::min(wide_lanes, chunk.end - first)};
}

/// `plain`: growth is that of Tissue::grows_plainly.
template <bool plain>
CORTICLE_INLINE material::WideTissue tissue_of(const Chunk& chunk, const WideGroup& group, const WideMat3& F)
{
    return plain ? material::plain_tissue(chunk.tissue, chunk.t, group)
                 : material::any_tissue(chunk.tissue, chunk.t, group, F);
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
    for (std::int64_t first = chunk.begin; first < chunk.end; first += wide_lanes)
    {
        const TetBlock& block = chunk.block_of(first);
        const WideGroup group = group_of(chunk, first);
        WideEdges edge;
        gather_edges(block, local, edge);
        const auto point = tissue_of<plain>(chunk, group, WideMat3::identity()).point; // whatever the normal
        const WideLanes grown = material::growth_volume<plain>(point) * in_lanes(block.volume);
        const WideVec3 quarter = 0.25 * WideVec3{volumes(edge), grown, point.bulk_modulus * grown};
        group.scatter_rows(quarter,
                           [&](int l, const Lanes& row)
                           {
                               for (const auto& corner : block.corner)
                               {
                                   reinterpret_cast<Lanes&>(parts[corner[l]]) += row;
                               }
                           });
    }
}

/// One tet of a block, where its law is extrapolated.
struct OneTet
{
    Mat3 F;
    Vec3 gradient[3]; ///< of the shape functions of the corners 1, 2, 3 in the reference configuration [1/mm]
    double volume;    ///< V [mm³]
    material::MaterialPoint point;
    Vec3 normal;
    BasicNodalSums<double> nodal;
};

/// What an extrapolated tet gives, as TetResponse has it.
struct OneResponse
{
    Vec3 force[3];
    double stiffness, energy, power;
};

/// Adds what the volumetric part of a tet does to what its deviatoric part does, where that is extrapolated; nothing
/// where it is not.
std::optional<OneResponse> extrapolate(const OneTet& tet)
{
    const material::MaterialPoint& point = tet.point;
    const material::ElasticDeformation<double> e = material::elastic_deformation(point, tet.normal, tet.F);
    const SingularValues elastic = singular_values(e.F_e);
    if (!(elastic.stretch.z < extrapolated_stretch))
    {
        return std::nullopt;
    }
    const material::ElasticResponse continued =
        extrapolated_deviatoric(elastic, point.shear_modulus, point.bulk_modulus);
    const double grown = tet.volume * material::growth_volume(point);
    const Mat3 P =
        grown * (continued.stress * e.inverse_G) + (0.25 * tet.nodal.pressure * tet.volume) * cofactor(tet.F);
    OneResponse out;
    double squared_gradients = 0.0;
    Vec3 sum;
    for (int a = 0; a < 3; ++a)
    {
        out.force[a] = -(P * tet.gradient[a]);
        squared_gradients += squared_norm(tet.gradient[a]);
        sum += tet.gradient[a];
    }
    squared_gradients += squared_norm(sum);
    out.energy = grown * (continued.deviatoric_energy + continued.volumetric_energy);
    out.power = grown * (material::growth_power(point, tet.normal, e.F_e, continued) + nodal_power(point, tet.nodal));
    // The tangent of the extrapolated law stays below about ten times that of the tissue at rest.
    constexpr double stiffening = 10.0;
    out.stiffness = grown * stiffening * material::longitudinal_modulus(point) * squared_gradients;
    return out;
}

CORTICLE_INLINE Vec3 vector_at(const WideVec3& v, int l)
{
    return {v.x[l], v.y[l], v.z[l]};
}

OneTet tet_in_lane(const TetBlock& block, const WideMat3& F, const material::WideTissue& tissue, const NodalSums& nodal,
                   int l)
{
    OneTet tet;
    const auto& point = tissue.point;
    tet.F = {{vector_at(F.column[0], l), vector_at(F.column[1], l), vector_at(F.column[2], l)}};
    for (int a = 0; a < 3; ++a)
    {
        tet.gradient[a] = vector_at(shape_gradient(block, a), l);
    }
    tet.volume = block.volume[l];
    tet.point = {point.growth[l],        point.radial_growth[l], point.growth_rate[l], point.radial_growth_rate[l],
                 point.shear_modulus[l], point.bulk_modulus[l],  point.shear_rate[l],  point.bulk_rate[l]};
    tet.normal = vector_at(tissue.normal, l);
    tet.nodal = {nodal.pressure[l], nodal.density[l], nodal.work[l]};
    return tet;
}

/// Extrapolates the tets of a block that are flat or inverted.
void extrapolate_flat(const TetBlock& block, const WideMat3& F, const material::WideTissue& tissue,
                      const NodalSums& nodal, const WideGroup& group, TetResponse& out,
                      mechanics::InternalResponse& sum)
{
    for (int l = 0; l < group.count; ++l)
    {
        if (out.flatness[l] > extrapolated_stretch)
        {
            continue;
        }
        sum.inverted_count += out.J[l] <= 0.0 ? 1 : 0;
        if (const auto one = extrapolate(tet_in_lane(block, F, tissue, nodal, l)))
        {
            ++sum.extrapolated_count;
            for (int a = 0; a < 3; ++a)
            {
                out.force[a].x[l] = one->force[a].x;
                out.force[a].y[l] = one->force[a].y;
                out.force[a].z[l] = one->force[a].z;
            }
            out.stiffness[l] = one->stiffness;
            out.energy[l] = one->energy;
            out.power[l] = one->power;
        }
    }
}

/// Adds the forces of a block to those of its nodes; their lanes sum the stiffness.
CORTICLE_INLINE void scatter_forces(const TetBlock& block, const TetResponse& out, const WideGroup& group, Vec3* parts)
{
    const auto add = [&](int corner, WideVec3 force)
    {
        force.lane = out.stiffness;
        group.scatter_rows(force, [&](int l, const Lanes& row) { lanes(parts[block.corner[corner][l]]) += row; });
    };
    add(0, -(out.force[0] + out.force[1] + out.force[2]));
    add(1, out.force[0]);
    add(2, out.force[1]);
    add(3, out.force[2]);
}

template <bool plain>
CORTICLE_INLINE void sum_forces(const Chunk& chunk, const Vec3* x, const NodalPressure* node_values, Vec3* parts,
                                mechanics::InternalResponse& sum)
{
    Lanes local[most_nodes];
    Lanes local_values[most_nodes];
    for (std::size_t k = 0; k < chunk.nodes.size(); ++k)
    {
        local[k] = lanes(x[chunk.nodes[k]]);
        local_values[k] = reinterpret_cast<const Lanes&>(node_values[chunk.nodes[k]]);
        parts[k] = {};
    }
    WideLanes energy{};
    WideLanes power{};
    for (std::int64_t first = chunk.begin; first < chunk.end; first += wide_lanes)
    {
        const TetBlock& block = chunk.block_of(first);
        const WideGroup group = group_of(chunk, first);
        WideEdges edge;
        gather_edges(block, local, edge);
        const WideMat3 F = gradients(block, edge);
        const material::WideTissue tissue = tissue_of<plain>(chunk, group, F);
        const WideVec3 values = (gather_corner(block, local_values, 0) + gather_corner(block, local_values, 1)) +
                                (gather_corner(block, local_values, 2) + gather_corner(block, local_values, 3));
        const NodalSums nodal{values.x, values.y, values.z};
        TetResponse out = respond<plain>(block, edge, F, tissue, nodal);
        bool any_flat = false;
        for_lanes(~(out.flatness > extrapolated_stretch), [&](int) { any_flat = true; });
        if (any_flat)
        {
            extrapolate_flat(block, F, tissue, nodal, group, out, sum);
        }
        scatter_forces(block, out, group, parts);
        energy += group.counted(out.energy);
        power += group.counted(out.power);
        for_lanes(out.J < sum.smallest_J,
                  [&](int l)
                  {
                      // The lanes that fill up the last block have all corners in one node, hence J = 0.
                      if (l < group.count && out.J[l] < sum.smallest_J)
                      {
                          sum.smallest_J = out.J[l];
                          sum.smallest_J_at = group.at(l);
                      }
                  });
    }
    sum.elastic_energy += sum_of_lanes(energy);
    sum.growth_power += sum_of_lanes(power);
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
                                     mechanics::InternalResponse& sum)
{
    sum_forces<true>(chunk, x, values, parts, sum);
}

CORTICLE_EVERY_ISA void general_forces(const Chunk& chunk, const Vec3* x, const NodalPressure* values, Vec3* parts,
                                       mechanics::InternalResponse& sum)
{
    sum_forces<false>(chunk, x, values, parts, sum);
}

} // namespace corticle::fem

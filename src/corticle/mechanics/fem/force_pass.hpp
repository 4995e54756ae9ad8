// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/dual.hpp"
#include "corticle/mechanics/fem/block_law.hpp"
#include "corticle/mechanics/fem/extrapolation.hpp"
#include "corticle/mechanics/fem/passes.hpp"

#include <memory>
#include <optional>

// What the law of the material does to tets: the pressures of the nodes, and the second sweep, which sums the forces.

namespace corticle::fem
{

/// Both with some law.
class ForcePass
{
  public:
    ForcePass() = default;
    ForcePass(const ForcePass&) = delete;
    ForcePass& operator=(const ForcePass&) = delete;
    virtual ~ForcePass() = default;

    /// Volume ratio below which the law resists further compression.
    virtual double barrier_J() const = 0;

    /// U and dU/dJ of a node, per bulk modulus.
    virtual material::VolumetricResponse<double> respond_to_volume(double ratio) const = 0;

    /// Parts of the forces on the chunk's nodes, the lane with the stiffness of TetResponse. Adds to `sum` what the
    /// tets give: deviatoric energy, growth power, counts, the smallest J.
    /// @param values  of all nodes
    virtual void run(const Chunk& chunk, const Vec3* x, const NodalPressure* values, Vec3* parts,
                     mechanics::InternalResponse& sum) const = 0;
};

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
template <class Law>
std::optional<OneResponse> extrapolate(const Law& law, const OneTet& tet)
{
    const material::MaterialPoint& point = tet.point;
    const material::ElasticDeformation<double> e = material::elastic_deformation(point, tet.normal, tet.F);
    const auto extrapolated = extrapolated_where_flat(law, e.F_e, point.shear_modulus, point.bulk_modulus);
    if (!extrapolated)
    {
        return std::nullopt;
    }
    const material::ElasticResponse& continued = *extrapolated;
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
    out.stiffness = grown * stiffening * material::longitudinal_modulus(law, point) * squared_gradients;
    return out;
}

CORTICLE_INLINE Vec3 vector_at(const WideVec3& v, int l)
{
    return {v.x[l], v.y[l], v.z[l]};
}

inline OneTet tet_in_lane(const TetBlock& block, const WideMat3& F, const material::WideTissue& tissue,
                          const NodalSums& nodal, int l)
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
template <class Law>
void extrapolate_flat(const Law& law, const TetBlock& block, const WideMat3& F, const material::WideTissue& tissue,
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
        if (const auto one = extrapolate(law_in_lane(law, l), tet_in_lane(block, F, tissue, nodal, l)))
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

/// Parts of the forces on the chunk's nodes, as ForcePass::run has them. `plain`: growth is that of
/// Tissue::grows_plainly.
template <bool plain, class Law>
CORTICLE_EVERY_ISA void sum_forces(const Law& law, const Chunk& chunk, const Vec3* x, const NodalPressure* node_values,
                                   Vec3* parts, mechanics::InternalResponse& sum)
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
    WideLanes released{};
    for (std::int64_t first = chunk.begin; first < chunk.end; first += wide_lanes)
    {
        const TetBlock& block = chunk.block_of(first);
        const WideGroup group = group_of(chunk, first);
        WideEdges edge;
        gather_edges(block, local, edge);
        const WideMat3 F = gradients(block, edge);
        material::WideTissue tissue = tissue_of<plain, material::HasHistory<Law>>(chunk, group, F);
        const auto& law_here = material::law_at(law, chunk.tissue, group, F, tissue);
        const WideVec3 values = (gather_corner(block, local_values, 0) + gather_corner(block, local_values, 1)) +
                                (gather_corner(block, local_values, 2) + gather_corner(block, local_values, 3));
        const NodalSums nodal{values.x, values.y, values.z};
        TetResponse out = respond<plain>(law_here, block, edge, F, tissue, nodal);
        bool any_flat = false;
        for_lanes(~(out.flatness > extrapolated_stretch), [&](int) { any_flat = true; });
        if (any_flat)
        {
            extrapolate_flat(law_here, block, F, tissue, nodal, group, out, sum);
        }
        scatter_forces(block, out, group, parts);
        energy += group.counted(out.energy);
        power += group.counted(out.power);
        released += group.counted(out.released);
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
    sum.released += sum_of_lanes(released);
}

/// The pass with one law, compiled for it.
template <material::Material<WideLanes> Law>
requires material::Material<Law> && material::Material<Law, Dual>
class LawForcePass final : public ForcePass
{
  public:
    explicit LawForcePass(const Law& law) : law_(law) {}

    double barrier_J() const override { return law_.barrier_J; }

    material::VolumetricResponse<double> respond_to_volume(double ratio) const override
    {
        return law_.respond_to_volume(1.0, ratio);
    }

    void run(const Chunk& chunk, const Vec3* x, const NodalPressure* values, Vec3* parts,
             mechanics::InternalResponse& sum) const override
    {
        if constexpr (!material::HasHistory<Law>)
        {
            if (chunk.tissue.grows_plainly())
            {
                return sum_forces<true>(law_, chunk, x, values, parts, sum);
            }
        }
        sum_forces<false>(law_, chunk, x, values, parts, sum);
    }

  private:
    Law law_;
};

/// All that a material needs to be simulated: hand the result to FemSolver.
template <class Law>
std::unique_ptr<const ForcePass> force_pass(const Law& law)
{
    return std::make_unique<LawForcePass<Law>>(law);
}

} // namespace corticle::fem

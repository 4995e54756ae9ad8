// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/boundary/fluid_term.hpp"

#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

using boundary::BoundaryOptions;
using boundary::Fluid;
using boundary::FluidTerm;

/// A sphere of 12.5 mm in one of 14 mm, in which every third vertex is moved.
struct Fixture
{
    const model::Model& model = *test::small_model();
    BoundaryOptions options;
    std::shared_ptr<boundary::Skull> skull;
    boundary::TiedSurface ventricles;
    mechanics::History history;

    explicit Fixture(Fluid fluid, boundary::SkullKind kind = boundary::SkullKind::rigid)
    {
        options.fluid = fluid;
        options.kind = kind;
        options.stiffness = 1e-6; // the fluid alone
        options.pressure = 0.3;
        options.times = {0.0, 1.0};
        options.scales = {1.0, 1.5};
        TriangleMesh surface = model.surface;
        for (Vec3& vertex : surface.vertices)
        {
            vertex *= 1.12;
        }
        skull = std::make_shared<boundary::Skull>(surface, options, 0.5, 0.0);
    }

    /// The tetrahedron of four nodes far apart, each vertex the mean of two of them.
    void add_ventricle()
    {
        const std::int32_t n = static_cast<std::int32_t>(model.cloud.positions.size());
        std::array<std::int32_t, 4> node{n / 9, n / 3, n / 2, 5 * n / 6};
        ventricles.triangles = {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}};
        for (std::size_t k = 0; k < 4; ++k)
        {
            ventricles.nodes.push_back({node[k], node[(k + 1) % 4], 0, 1});
            ventricles.weights.push_back({0.7, 0.3, 0.0, 0.0});
        }
        options.ventricle_pressure = 0.2;
    }

    FluidTerm term(bool with_skull = true) const
    {
        return {model.cloud, model.surface, model.cloud.volumes, ventricles, with_skull ? skull : nullptr, options,
                0.0};
    }

    mechanics::Contribution evaluate(FluidTerm& fluid, std::span<const Vec3> x, std::vector<Vec3>& forces,
                                     double t = 0.5)
    {
        const std::vector<Vec3> v(x.size());
        const mechanics::StepContext context{t, t, 1.0, 0.6, x, v, history};
        forces.assign(x.size(), {});
        skull->begin(context);
        return fluid.add(context, forces);
    }
};

double energy_of(const FluidTerm& fluid)
{
    return fluid.energies().front().value;
}

void expect_forces_from_energy(Fixture& set, bool with_skull)
{
    FluidTerm fluid = set.term(with_skull);
    std::vector<Vec3> x = test::perturbed(set.model.cloud.positions, 0.2);
    std::vector<Vec3> forces;
    set.evaluate(fluid, x, forces);
    const double largest = test::largest_norm(forces);
    ASSERT_GT(largest, 0.0);
    const double step = 1e-4;
    std::vector<std::int32_t> nodes{set.model.cloud.surface_particles[0], set.model.cloud.surface_particles[77]};
    for (const auto& tied : set.ventricles.nodes)
    {
        nodes.push_back(tied[0]);
    }
    std::vector<Vec3> other;
    for (const std::int32_t i : nodes)
    {
        for (int axis = 0; axis < 3; ++axis)
        {
            std::vector<Vec3> moved = x;
            moved[i][axis] += step;
            set.evaluate(fluid, moved, other);
            const double above = energy_of(fluid);
            moved[i][axis] -= 2.0 * step;
            set.evaluate(fluid, moved, other);
            const double below = energy_of(fluid);
            EXPECT_NEAR(forces[i][axis], (below - above) / (2.0 * step), 1e-6 * largest);
        }
    }
}

TEST(Fluid, ForcesAreMinusTheGradientOfItsEnergy)
{
    Fixture constant(Fluid::constant);
    constant.add_ventricle();
    expect_forces_from_energy(constant, false);
    expect_forces_from_energy(constant, true);
    Fixture conserved(Fluid::conserved);
    expect_forces_from_energy(conserved, true);
}

TEST(Fluid, ForcesOnTheSkullAreMinusTheGradientToo)
{
    Fixture set(Fluid::conserved, boundary::SkullKind::elastic);
    FluidTerm fluid = set.term();
    const std::vector<Vec3> x = test::perturbed(set.model.cloud.positions, 0.2);
    std::vector<Vec3> forces;
    const double step = 1e-4;
    std::vector<Vec3> ways(set.skull->positions().size());
    const auto energy_at = [&](std::size_t k, int axis, double way)
    {
        ways.assign(ways.size(), {});
        ways[k][axis] = way;
        set.skull->move(ways, 1.0);
        set.evaluate(fluid, x, forces);
        return energy_of(fluid) + set.skull->spring_energy();
    };
    for (int axis = 0; axis < 3; ++axis)
    {
        energy_at(5, axis, 0.0);
        const double force = set.skull->forces()[5][axis];
        const double expected = (energy_at(5, axis, -step) - energy_at(5, axis, step)) / (2.0 * step);
        EXPECT_NEAR(force, expected, 1e-6 * test::largest_norm(set.skull->forces()));
    }
}

TEST(Fluid, KeepsMomentumAndAngularMomentum)
{
    Fixture set(Fluid::constant);
    set.add_ventricle();
    FluidTerm fluid = set.term(false);
    const std::vector<Vec3> x = test::perturbed(set.model.cloud.positions, 0.2);
    std::vector<Vec3> forces;
    set.evaluate(fluid, x, forces);
    Vec3 sum;
    Vec3 torque;
    double scale = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i)
    {
        sum += forces[i];
        torque += cross(x[i], forces[i]);
        scale += norm(forces[i]);
    }
    EXPECT_LT(norm(sum), 1e-13 * scale);
    EXPECT_LT(norm(torque), 1e-12 * scale);
}

TEST(Fluid, ThePressureOfAConservedOneIsThatOfItsVolume)
{
    Fixture set(Fluid::conserved);
    set.options.times.clear();
    set.options.scales.clear();
    FluidTerm fluid = set.term();
    std::vector<Vec3> forces;
    set.evaluate(fluid, set.model.cloud.positions, forces);
    EXPECT_EQ(fluid.pressure(), 0.0);
    const double at_rest = fluid.outer_volume();
    const std::vector<Vec3> larger = test::affine(set.model.cloud.positions, 1.01 * Mat3::identity());
    const mechanics::Contribution contribution = set.evaluate(fluid, larger, forces);
    EXPECT_NEAR(fluid.pressure(), set.options.bulk_modulus * (1.0 - fluid.outer_volume() / at_rest), 1e-12);
    EXPECT_GT(fluid.pressure(), 0.0);
    EXPECT_LT(contribution.stable_step, 1e3);
}

} // namespace
} // namespace corticle

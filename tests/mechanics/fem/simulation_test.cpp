// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/model/simulation.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/shapes.hpp"
#include "corticle/geometry/tetrahedralize.hpp"
#include "corticle/record/body_file.hpp"
#include "corticle/record/checkpointing.hpp"
#include "formats/temporary_folder.hpp"
#include "formats/tets/tet_writers.hpp"
#include "mechanics/fem/small_tets.hpp"
#include "mesh/mesh_volume.hpp"
#include "model/same_bits.hpp"

#include <gtest/gtest.h>

namespace corticle
{
namespace
{

config::Options fem_options()
{
    config::Options options;
    options.method = model::Method::fem;
    options.elements = 5000;
    options.contact.distance = 0.6; // contact is at work where the start is rough
    options.tissue.thickness_rate_mm = 0.4;
    return options;
}

model::Simulation rough_start(model::Model& body, const config::Options& options)
{
    model::Simulation simulation(test::shared(body), options);
    model::State state;
    state.motion.x = test::perturbed(body.cloud.positions, 0.15 * body.cloud.spacing);
    state.motion.v.resize(state.motion.x.size());
    simulation.restore(std::move(state));
    return simulation;
}

using test::expect_same_bits;
using test::take_steps;

TEST(FemSimulation, OneAndTwoThreadsGiveTheSameBitsFromTheMeshOn)
{
    const config::Options options = fem_options();
    const int threads = thread_count();
    set_thread_count(1);
    model::Model body_of_one = prepare::prepare_body(options).model;
    model::Simulation one = rough_start(body_of_one, options);
    take_steps(one, 40);
    set_thread_count(2);
    model::Model body_of_two = prepare::prepare_body(options).model;
    model::Simulation two = rough_start(body_of_two, options);
    take_steps(two, 40);
    set_thread_count(threads);
    ASSERT_EQ(body_of_one.fem->elements.tets, body_of_two.fem->elements.tets);
    expect_same_bits(one, two);
}

TEST(FemSimulation, GoesOnFromACheckpointAndABodyFileToTheSameBits)
{
    const config::Options options = fem_options();
    const TemporaryFolder folder;
    prepare::Preparation made = prepare::prepare_body(options);
    model::Model& body = made.model;
    record::write_body(folder / "body.h5", made, options);
    model::Simulation whole = rough_start(body, options);
    take_steps(whole, 20);
    EXPECT_GT(whole.contact().active, 0);
    const record::Checkpoint checkpoint = record::to_checkpoint(whole.state(), {}, "case");
    take_steps(whole, 20);

    prepare::Preparation made_again = record::read_body(folder / "body.h5", options);
    prepare::connect_body(options, made_again);
    model::Model& read = made_again.model;
    model::Simulation resumed(test::shared(read), options);
    resumed.restore(record::from_checkpoint(checkpoint, read.cloud.positions.size(), "checkpoint.h5").state);
    take_steps(resumed, 20);
    expect_same_bits(whole, resumed);

    config::Options particles = options;
    particles.method = model::Method::tlsph;
    particles.elements.reset();
    EXPECT_THROW(record::read_body(folder / "body.h5", particles), InputError);
}

TEST(FemSimulation, EnergyBalanceOfGrowthBalance)
{
    config::Options options;
    options.method = model::Method::fem;
    options.elements = 10000;
    options.contact.enabled = false;
    options.dynamics.cfl = 0.3;
    model::Model body = prepare::prepare_body(options).model;
    model::Simulation simulation(test::shared(body), options);
    while (simulation.state().t < 0.1)
    {
        simulation.step(0.1);
    }
    const model::State& state = simulation.state();
    const double stored = simulation.internal().elastic_energy;
    EXPECT_NEAR((stored + state.kinetic_energy + state.energy_balance.dissipated) / state.energy_balance.growth_work,
                1.0, 0.002);
    EXPECT_LT(state.kinetic_energy, 0.05 * stored);
}

TEST(FemBody, SharesItsSurfaceWithTheParticlesOfTheSameSpacing)
{
    config::Options options;
    options.geometry.spacing_mm = 1.5;
    const model::Model particles = prepare::prepare_body(options).model;
    options.method = model::Method::fem;
    const model::Model elements = prepare::prepare_body(options).model;
    options.method = model::Method::tlsph;
    options.geometry.arrangement = prepare::Arrangement::mesh_nodes;
    const model::Model nodes = prepare::prepare_body(options).model;
    EXPECT_EQ(particles.surface.vertices, elements.surface.vertices);
    EXPECT_NEAR(elements.cloud.spacing / 1.5, 1.0, 0.03);
    EXPECT_EQ(nodes.cloud.positions, elements.cloud.positions);
    EXPECT_EQ(nodes.cloud.volumes, elements.cloud.volumes);
    EXPECT_FALSE(nodes.fem);
}

TEST(FemBody, TakesTheTetsOfAFileAsTheyAre)
{
    const TemporaryFolder folder;
    const TriangleMesh surface = geometry::make_ellipsoid({8.0, 8.0, 8.0}, 1.5);
    const TetMesh mesh = geometry::tetrahedralize(surface, 900);
    write_tets_msh(folder / "ball.msh", mesh);
    config::Options options;
    options.method = model::Method::fem;
    options.geometry.shape = prepare::Shape::file;
    options.geometry.file = (folder / "ball.msh").string();
    options.geometry.arrangement = prepare::Arrangement::tet_nodes;
    const model::Model body = prepare::prepare_body(options).model;
    EXPECT_EQ(body.fem->elements.tets.size(), mesh.tets.size());
    EXPECT_EQ(body.cloud.positions.size(), mesh.vertices.size());
    EXPECT_NEAR(mesh_volume({body.fem->elements.X, body.fem->elements.tets}) / mesh_volume(mesh), 1.0, 1e-12);
    options.geometry.arrangement = prepare::Arrangement::body_fitted;
    options.elements = 6000;
    EXPECT_NEAR(static_cast<double>(prepare::prepare_body(options).model.fem->elements.tets.size()) / 6000.0, 1.0, 0.1);
}

} // namespace
} // namespace corticle

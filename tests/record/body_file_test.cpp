// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/body_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/record/checkpoint.hpp"
#include "formats/temporary_folder.hpp"
#include "mechanics/tlsph/small_body.hpp"

#include <gtest/gtest.h>

namespace corticle
{

TEST(BodyFile, ReadsBackToTheSameBits)
{
    const TemporaryFolder folder;
    const config::Options options = test::sphere_options(2500);
    prepare::Preparation made{*test::small_model(), {}};
    model::Model& written = made.model;
    for (std::size_t i = 0; i < written.cloud.positions.size(); ++i)
    {
        const double x = written.cloud.positions[i].x;
        written.tissue.mapped_rate[i] = 1.0 + 0.01 * x;
        written.tissue.growth_onset.push_back(0.02 * x);
        written.tissue.growth_rate.push_back(2.0 + 0.03 * x);
        written.tissue.thickness.push_back(2.0 + 0.04 * x);
        written.tissue.region.push_back(x > 0.0 ? 7.0 : 3.0);
    }
    prepare::connect_body(options, made);
    record::write_body(folder / "body.h5", made, options);
    prepare::Preparation read = record::read_body(folder / "body.h5", options);
    prepare::connect_body(options, read);
    const model::Model& body = read.model;
    EXPECT_EQ(body.cloud.positions, written.cloud.positions);
    EXPECT_EQ(body.cloud.volumes, written.cloud.volumes);
    EXPECT_EQ(body.cloud.surface_particles, written.cloud.surface_particles);
    EXPECT_EQ(body.cloud.surface_triangles, written.cloud.surface_triangles);
    EXPECT_EQ(body.cloud.spacing, written.cloud.spacing);
    EXPECT_EQ(body.surface.vertices, written.surface.vertices);
    EXPECT_EQ(body.surface.triangles, written.surface.triangles);
    EXPECT_EQ(body.tissue.depth, written.tissue.depth);
    EXPECT_EQ(body.tissue.normal, written.tissue.normal);
    EXPECT_EQ(body.tissue.regional_rate, written.tissue.regional_rate);
    EXPECT_EQ(body.tissue.growth_onset, written.tissue.growth_onset);
    EXPECT_EQ(body.tissue.growth_rate, written.tissue.growth_rate);
    EXPECT_EQ(body.tissue.thickness, written.tissue.thickness);
    EXPECT_EQ(body.tissue.region, written.tissue.region);
    EXPECT_EQ(body.particles.pairs.place, written.particles.pairs.place);
    EXPECT_EQ(body.particles.pairs.weight, written.particles.pairs.weight);
}

TEST(BodyFile, TissueMayDifferAndGeometryMayNot)
{
    const TemporaryFolder folder;
    record::write_body(folder / "body.h5", {*test::small_model(), {}}, test::sphere_options(2500));
    config::Options options = test::sphere_options(2500);
    options.tissue.mu_cortex = 2.0;
    EXPECT_NO_THROW(record::read_body(folder / "body.h5", options));
    options.geometry.seed = 2;
    const std::string message = message_of<InputError>([&] { record::read_body(folder / "body.h5", options); });
    EXPECT_NE(message.find("geometry.seed: 1 -> 2"), std::string::npos) << message;
}

TEST(BodyFile, RefusesWhatIsNoBody)
{
    const TemporaryFolder folder;
    const config::Options options = test::sphere_options(2500);
    EXPECT_THROW(record::read_body(folder / "none.h5", options), InputError);
    put_bytes(folder / "text.h5", "no body");
    EXPECT_THROW(record::read_body(folder / "text.h5", options), InputError);
    record::Checkpoint checkpoint;
    checkpoint.vectors["position"] = {{0.0, 0.0, 0.0}};
    record::write_checkpoint(folder / "checkpoint.h5", checkpoint);
    const std::string message = message_of<InputError>([&] { record::read_body(folder / "checkpoint.h5", options); });
    EXPECT_NE(message.find("corticle prepare"), std::string::npos) << message;
}

} // namespace corticle

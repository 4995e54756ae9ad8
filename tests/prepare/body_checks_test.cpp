// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/parameters/options.hpp"
#include "corticle/prepare/body_checks.hpp"
#include "corticle/prepare/prepare.hpp"

#include "corticle/base/error.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{

namespace
{

using testing::HasSubstr;

/// Five places 0 to 4 mm deep.
struct Column
{
    config::Options options;
    std::vector<Vec3> places;
    material::TissueFields tissue;

    Column()
    {
        for (int k = 0; k < 5; ++k)
        {
            places.push_back({10.0 - k, 0.0, 0.0});
            tissue.depth.push_back(k);
        }
    }
    std::string refusal()
    {
        return message_of<InputError>([&] { prepare::require_cortex(options, places, tissue); });
    }
};

} // namespace

TEST(BodyChecks, ACortexThinnerThanTheBodyPasses)
{
    Column column;
    column.options.tissue.thickness_mm = 3.9;
    EXPECT_EQ(column.refusal(), "");
}

TEST(BodyChecks, ACortexThatIsTheWholeBodyIsRefused)
{
    Column column;
    column.options.tissue.thickness_mm = 8.0;
    EXPECT_THAT(column.refusal(), HasSubstr("the cortex of 8 mm is thicker than the body (largest depth 4 mm)"));
    EXPECT_THAT(column.refusal(), Not(HasSubstr("unit")));
    column.options.geometry.shape = prepare::Shape::file;
    column.options.geometry.file = "brain.stl";
    EXPECT_THAT(column.refusal(), HasSubstr("is geometry.unit right?"));
    column.options.geometry.file = "labels.nii.gz";
    EXPECT_THAT(column.refusal(), HasSubstr("are the voxel sizes of the image right?"));
}

TEST(BodyChecks, AThicknessThatComesToNothingSomewhereIsRefused)
{
    Column column;
    column.options.map.thickness_file = "map.txt";
    column.options.tissue.thickness_rate_mm = -0.6;
    column.tissue.thickness = {2.0, 2.0, 0.5, 2.0, 2.0};
    EXPECT_THAT(column.refusal(), HasSubstr("the cortex near (8, 0, 0) mm, 0.5 mm thick at t = 0 by map.thickness_file "
                                            "map.txt, has -0.1 mm at t = 1"));
    column.options.time.end = 0.5;
    EXPECT_EQ(column.refusal(), "");
    column.options.tissue.thickness_rate_mm = -1.0; // to exactly 0
    EXPECT_NE(column.refusal(), "");
}

TEST(BodyChecks, ABodyFarFromTheSizeOfABrainIsSaid)
{
    config::Options options;
    model::Model body;
    body.cloud.volumes.assign(1000, 1e-6);
    EXPECT_EQ(prepare::size_warning(options, body), ""); // a built-in shape may be a model of anything
    options.geometry.shape = prepare::Shape::file;
    options.geometry.file = "brain.stl";
    EXPECT_THAT(prepare::size_warning(options, body),
                HasSubstr("0.001 mm³ is far smaller than any brain; is geometry.unit"));
    body.cloud.volumes.assign(1000, 1e5);
    EXPECT_THAT(prepare::size_warning(options, body), HasSubstr("far larger than any brain"));
    body.cloud.volumes.assign(1000, 300.0);
    EXPECT_EQ(prepare::size_warning(options, body), "");
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace corticle
{
namespace
{

config::Options read(const std::string& text)
{
    return config::parse_case(text, "case.toml", {}, "");
}

TEST(Formulation, OneKeySelectsAllThatTheThesisDoes)
{
    const config::Options options = read("[solver]\nformulation = \"thesis\"\n");
    EXPECT_EQ(options.formulation, thesis::Formulation::thesis);
    EXPECT_EQ(options.thesis.growth, thesis::GrowthEntry::multiplied);
    EXPECT_EQ(options.thesis.force, thesis::ForceForm::difference);
    EXPECT_EQ(options.thesis.gradient, thesis::KernelGradient::plain);
    EXPECT_EQ(options.thesis.viscosity_alpha, 0.04);
    EXPECT_EQ(options.thesis.viscosity_beta, 0.08);
    EXPECT_EQ(options.geometry.volumes, prepare::VolumeRule::neighbour_count);
    EXPECT_EQ(options.geometry.normals, prepare::NormalRule::divisions);
    EXPECT_EQ(options.tissue.layer, material::Layer::binary);
    EXPECT_EQ(options.tissue.lambda, 0.75);
    EXPECT_EQ(options.tissue.barrier_J, 0.0);
    EXPECT_EQ(options.tlsph.kernel_mm, 3.5);
    EXPECT_EQ(options.tlsph.zeta, 0.0);
    EXPECT_EQ(options.dynamics.integrator, dynamics::Integrator::rk4);
    EXPECT_EQ(options.dynamics.time_step, 2e-5);
    EXPECT_EQ(options.dynamics.damping, 0.0);
    EXPECT_EQ(options.dynamics.max_halvings, 0);
    EXPECT_FALSE(options.contact.enabled);
}

TEST(Formulation, WhatTheCaseGivesStays)
{
    const config::Options options =
        read("[solver]\nkernel_mm = 3.0\nformulation = \"thesis\"\nintegrator = \"symplectic_euler\"\n"
             "[contact]\nenabled = true\n[tissue]\nlayer = \"smooth\"\n[thesis]\ngrowth = \"divided\"\n");
    EXPECT_EQ(options.tlsph.kernel_mm, 3.0);
    EXPECT_EQ(options.dynamics.integrator, dynamics::Integrator::symplectic_euler);
    EXPECT_TRUE(options.contact.enabled);
    EXPECT_EQ(options.tissue.layer, material::Layer::smooth);
    EXPECT_EQ(options.tissue.lambda, 0.0); // which a smooth layer has no use for
    EXPECT_EQ(options.thesis.growth, thesis::GrowthEntry::divided);
    EXPECT_EQ(options.geometry.volumes, prepare::VolumeRule::neighbour_count);
}

TEST(Formulation, AResolvedCaseReadsBackEqual)
{
    const config::Options options =
        read("[solver]\nformulation = \"thesis\"\nkernel_mm = 4.0\n[thesis]\nforce = \"conservative\"\n");
    EXPECT_EQ(config::to_toml(read(config::to_toml(options))), config::to_toml(options));
    EXPECT_THAT(config::to_toml(options), testing::HasSubstr("force = \"conservative\""));
    EXPECT_THAT(config::to_toml(read("")), testing::Not(testing::HasSubstr("[thesis]")));
}

TEST(Formulation, WhatDoesNotGoTogetherIsRefused)
{
    const auto message = [](const std::string& text) -> std::string
    {
        try
        {
            read(text);
        }
        catch (const InputError& error)
        {
            return error.what();
        }
        return "";
    };
    using testing::AllOf;
    using testing::HasSubstr;
    EXPECT_THAT(message("[thesis]\nforce = \"difference\"\n"),
                AllOf(HasSubstr("thesis.force (case.toml:2)"), HasSubstr("formulation")));
    EXPECT_THAT(message("[solver]\nintegrator = \"rk4\"\n"), AllOf(HasSubstr("contact.enabled"), HasSubstr("rk4")));
    EXPECT_THAT(message("[solver]\nformulation = \"thesis\"\ntime_step = -1.0\n"), HasSubstr("solver.time_step"));
}

} // namespace
} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/fit/fit_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/study/fit/emulator.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

namespace corticle
{

namespace
{

using ::testing::HasSubstr;

constexpr const char* parameter = "[[parameter]]\nkey = \"tissue.mu_cortex\"\nlow = 0.5\nhigh = 2.0\nscale = \"log\"\n";
constexpr const char* target = "[[target]]\nmeasure = \"gi_hull\"\nt = 0.5\nvalue = 1.2\nsd = 0.02\n";

class FitFile : public ::testing::Test
{
  protected:
    FitFile() { std::ofstream(folder_.path() / "base.toml") << "[geometry]\nparticles = 600\n"; }

    fit::FitFile parse(const std::string& text) const
    {
        return fit::parse_fit("base = \"base.toml\"\n" + text, "fit.toml", folder_.path(), {});
    }
    std::string refusal(const std::string& text) const
    {
        try
        {
            parse(text);
            return "";
        }
        catch (const InputError& error)
        {
            return error.what();
        }
    }

    TemporaryFolder folder_;
};

fit::Quantity observed(double value, double sd)
{
    fit::Quantity quantity;
    quantity.measure = "gi_hull";
    quantity.value = value;
    quantity.sd = sd;
    return quantity;
}

} // namespace

TEST_F(FitFile, ParametersAreScaled)
{
    const fit::FitFile fit = parse(std::string(parameter) + target);
    const fit::FreeParameter& one = fit.space.parameters.front();
    EXPECT_NEAR(one.value(0.5), 1.0, 1e-12); // the geometric mean
    EXPECT_NEAR(one.unit_of(one.value(0.3)), 0.3, 1e-12);
    EXPECT_EQ(one.value(0.0), 0.5);
    EXPECT_EQ(one.value(1.0), 2.0);
    EXPECT_NEAR(fit.space.values(fit.space.start())[0], 0.86, 1e-12); // that of the base
    EXPECT_EQ(fit.surrogate.points, 12);
    EXPECT_FALSE(fit.search);
}

TEST_F(FitFile, ANumberOfAListIsAParameter)
{
    const std::string mode = "[[parameter]]\nkey = \"map.modes.{}\"\nlow = -0.3\nhigh = 0.5\n";
    const auto of = [&](const std::string& number) { return std::string(mode).replace(mode.find("{}"), 2, number); };
    const fit::FitFile fit = parse(of("3") + of("1") + target + "[set]\nmap.modes = [0.05, -0.1]\n");
    EXPECT_EQ(fit.space.parameters[0].name(), "modes.3");
    EXPECT_NEAR(fit.space.values(fit.space.start())[0], 0.0, 1e-12); // beyond the list of the base
    EXPECT_NEAR(fit.space.values(fit.space.start())[1], 0.05, 1e-12);
    const std::vector<double> u{1.0, 0.0};
    EXPECT_EQ(fit.space.overrides(u), std::vector<std::string>{"map.modes=[-0.3, -0.1, 0.5]"});

    EXPECT_THAT(refusal(of("0") + target), HasSubstr("map.modes.0"));
    EXPECT_THAT(refusal(of("101") + target), HasSubstr("map.modes.101"));
    EXPECT_THAT(refusal(of("x") + target), HasSubstr("map.modes.x"));
    EXPECT_THAT(refusal("[[parameter]]\nkey = \"map.modes\"\nlow = 0\nhigh = 1\n" + std::string(target)),
                HasSubstr("one of its numbers: \"map.modes.1\""));
    EXPECT_THAT(refusal("[[parameter]]\nkey = \"map.modes.1\"\nlow = -3\nhigh = 1\n" + std::string(target)),
                HasSubstr("-3"));
}

TEST_F(FitFile, WhatCannotBeMeantIsRefused)
{
    const std::string both = std::string(parameter) + target;
    EXPECT_THAT(refusal(target), HasSubstr("parameter"));
    EXPECT_THAT(refusal(parameter), HasSubstr("[[target]]"));
    EXPECT_THAT(refusal(both + "colour = 1\n"), HasSubstr("colour"));
    EXPECT_THAT(refusal(both + "[search]\nmethod = \"LBFGS\"\n"), HasSubstr("BOBYQA"));
    EXPECT_THAT(refusal(both + "[surrogate]\npoints = 0\n"), HasSubstr("[search]"));
    EXPECT_THAT(refusal(both + "[surrogate]\npoints = 2\n"), HasSubstr("at least 4"));
    EXPECT_THAT(refusal(both + "[set]\ntissue.mu_cortex = 1\n"), HasSubstr("both set and"));
    EXPECT_THAT(refusal(both + "[fidelity]\nruns = 2\n"), HasSubstr("without set"));
    EXPECT_THAT(refusal(both + parameter), HasSubstr("two [[parameter]]"));
    EXPECT_THAT(refusal(both + target), HasSubstr("twice"));
    const auto with = [&](const std::string& from, const std::string& to)
    {
        std::string text = both;
        text.replace(text.find(from), from.size(), to);
        return refusal(text);
    };
    EXPECT_THAT(with("low = 0.5", "low = 3.0"), HasSubstr("low < high"));
    EXPECT_THAT(with("low = 0.5", "low = 0"), HasSubstr("bound of 0"));
    EXPECT_THAT(with("tissue.mu_cortex", "tissue.mu_cortx"), HasSubstr("tissue.mu_cortex?"));
    EXPECT_THAT(with("tissue.mu_cortex", "tissue.layer"), HasSubstr("number"));
    EXPECT_THAT(with("scale = \"log\"", "prior = \"normal\"\nsd = 1"), HasSubstr("without mean"));
    EXPECT_THAT(with("scale = \"log\"", "mean = 1"), HasSubstr("prior"));
    EXPECT_THAT(with("scale = \"log\"", "start = 5"), HasSubstr("start of 5"));
    EXPECT_THAT(with("gi_hull", "gi_hul"), HasSubstr("gi_hul"));
    EXPECT_THAT(with("t = 0.5", "t = 1.5"), HasSubstr("runs from"));
    EXPECT_THAT(with("t = 0.5", "week = 28"), HasSubstr("clock"));
    EXPECT_THAT(with("t = 0.5", "t = 0.5\nweek = 28"), HasSubstr("both"));
    EXPECT_THAT(with("sd = 0.02", ""), HasSubstr("sd > 0"));
    EXPECT_THAT(with("sd = 0.02", "sd = 0.02\nrelative_sd = 0.1"), HasSubstr("sd and relative_sd"));
    EXPECT_THAT(with("sd = 0.02", "sd = -1"), HasSubstr("> 0"));
}

TEST(Emulator, CorrectionsAreAddedAndWidenWhatIsExpected)
{
    const std::vector<fit::Quantity> quantities{observed(2.0, 0.1)};
    std::vector<fit::Evaluation> runs;
    for (const fit::Point& u : fit::latin_hypercube(8, 1, 1))
    {
        runs.push_back({"design", u, {}, "", "", {1.0 + u[0]}});
    }
    runs.push_back({"design", {0.5}, {}, "", "it failed", {}});
    fit::Emulator emulator(runs, quantities);
    EXPECT_EQ(emulator.runs(), 8u);
    EXPECT_NEAR(emulator.predict(fit::Point{0.25}).mean(0), 1.25, 1e-4);
    emulator.correct(
        std::vector<fit::Evaluation>{{"dear", {0.2}, {}, "", "", {1.5}}, {"dear", {0.6}, {}, "", "", {2.0}}});
    EXPECT_NEAR(emulator.correction()(0), 0.35, 1e-4); // of 0.3 and 0.4
    EXPECT_NEAR(emulator.correction_variance()(0), 0.005 * 1.5, 1e-5);
    const auto predicted = emulator.predict(fit::Point{0.25});
    EXPECT_NEAR(predicted.mean(0), 1.6, 1e-4);
    EXPECT_GT(predicted.variance(0), 0.005);
    // The likeliest place of the observed 2.0 is where 1 + u + 0.35 is 2.
    EXPECT_GT(emulator.log_likelihood(fit::Point{0.65}), emulator.log_likelihood(fit::Point{0.6}));
    EXPECT_GT(emulator.log_likelihood(fit::Point{0.65}), emulator.log_likelihood(fit::Point{0.7}));
}

TEST(Emulator, SaysHowMuchOfTheVarianceItMakes)
{
    const std::vector<fit::Quantity> quantities{observed(1.5, 0.1)};
    std::vector<fit::Evaluation> smooth;
    std::vector<fit::Evaluation> scattered;
    for (const fit::Point& u : fit::latin_hypercube(16, 1, 1))
    {
        smooth.push_back({"design", u, {}, "", "", {1.0 + u[0]}});
        scattered.push_back({"design", u, {}, "", "", {1.0 + u[0] + (smooth.size() % 2 == 0 ? 0.1 : -0.1)}});
    }
    const fit::Point middle{0.5};
    EXPECT_LT(fit::Emulator(smooth, quantities).variance_shares(middle)(0), 1e-3);
    const double share = fit::Emulator(scattered, quantities).variance_shares(middle)(0);
    EXPECT_GT(share, 0.4); // scatter as large as the error of the observation
    EXPECT_LT(share, 0.7);
}

} // namespace corticle

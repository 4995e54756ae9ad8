// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/run_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/record/checkpoint.hpp"
#include "formats/temporary_folder.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <csignal>

namespace corticle
{

namespace
{

record::RunRequest small_run(const std::filesystem::path& out)
{
    record::RunRequest request;
    request.options = config::parse_case("[geometry]\nparticles = 600\n[tissue]\nthickness_mm = 5\n[time]\nend = 0.01\n"
                                         "[output]\ncount = 1\npictures = \"off\"\n",
                                         "case", {}, "");
    request.out = out;
    request.quiet = true;
    return request;
}

nlohmann::json summary_of(const std::filesystem::path& run)
{
    return nlohmann::json::parse(bytes_of(run / "summary.json"));
}

} // namespace

TEST(RunFolder, AnInvalidStartIsAFailureInTheSummary)
{
    const TemporaryFolder place;
    record::RunRequest request = small_run(place / "run");
    EXPECT_EQ(study::simulate(request), model::RunStatus::completed);
    record::Checkpoint checkpoint = record::read_checkpoint(place / "run/checkpoint.h5");
    for (Vec3& x : checkpoint.vectors["position"])
    {
        x.x = -x.x; // inside out
    }
    record::write_checkpoint(place / "run/checkpoint.h5", checkpoint);
    request.resume = true;
    EXPECT_THROW(study::simulate(request), RunError);
    const auto summary = summary_of(place / "run");
    EXPECT_EQ(summary["status"], "failed");
    EXPECT_THAT(summary["reason"].get<std::string>(), testing::HasSubstr("inverted"));
}

TEST(RunFolder, ARunLeavesTheHandlersOfSignalsAsItFoundThem)
{
    const TemporaryFolder place;
    const auto mine = [](int) {};
    void (*const handler)(int) = mine;
    std::signal(SIGINT, handler);
    EXPECT_EQ(study::simulate(small_run(place / "run")), model::RunStatus::completed);
    EXPECT_EQ(std::signal(SIGINT, SIG_DFL), handler);
}

} // namespace corticle

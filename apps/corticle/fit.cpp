// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/study/interruption.hpp"

namespace corticle
{

int fit_command(fit::FitRequest request)
{
    study::exit_when_interrupted();
    request.out = request.out.empty() ? std::filesystem::path("runs") / request.file.stem() : request.out;
    return fit::fit(request) == model::RunStatus::completed ? exit_status::done : exit_status::interrupted;
}

int sensitivity_command(sensitivity::SensitivityRequest request)
{
    study::exit_when_interrupted();
    request.out = request.out.empty() ? std::filesystem::path("runs") / request.file.stem() : request.out;
    return sensitivity::analyze(request) == model::RunStatus::completed ? exit_status::done : exit_status::interrupted;
}

int regions_command(regions::RegionsRequest request)
{
    study::exit_when_interrupted();
    request.out = request.out.empty() ? std::filesystem::path("runs") / (request.case_file.stem().string() + "_regions")
                                      : request.out;
    return regions::regional_growth(request) == model::RunStatus::completed ? exit_status::done
                                                                            : exit_status::interrupted;
}

} // namespace corticle

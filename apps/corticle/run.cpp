// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_folder.hpp"
#include "commands.hpp"

#include "corticle/base/communicator.hpp"
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/report/run_ending.hpp"
#include "corticle/study/interruption.hpp"
#include "corticle/study/run_folder.hpp"

#include <fmt/format.h>

#include <new>

namespace corticle
{

namespace
{

int run_on(const Communicator& ranks, RunArguments& arguments)
{
    record::RunRequest& request = arguments.request;
    request.out = chosen_folder(request.out, "runs", arguments.case_file);
    if (config::is_standard_input(arguments.case_file) && ranks.size() > 1)
    {
        throw InputError(fmt::format("a case on the standard input reaches one process only: got {}, expected a file",
                                     ranks.size()));
    }
    request.options = config::read_case(arguments.case_file, arguments.overrides);
    config::identify_inputs(request.options);
    std::error_code error;
    if (std::filesystem::is_directory(request.body, error))
    {
        request.body /= "body.h5";
    }
    if (study::simulate(request, ranks) != model::RunStatus::completed)
    {
        return exit_status::interrupted;
    }
    if (!ranks.is_root())
    {
        return exit_status::done;
    }
    if (request.options.output.report == config::PictureRule::on)
    {
        write_report_beside(request.out, request.quiet);
    }
    if (!request.quiet)
    {
        fmt::print("{}", report::run_ending(request.out));
    }
    return exit_status::done;
}

/// One message, whichever ranks fail: that of rank 0 where all fail alike. Where one fails alone the others wait for it
/// in vain: it says why, and ends them.
int end_together(const Communicator& ranks, const std::exception& error)
{
    constexpr double patience_s = 5.0;
    const int status =
        dynamic_cast<const InputError*>(&error) != nullptr ? exit_status::bad_input : exit_status::failed;
    const std::string message = dynamic_cast<const std::bad_alloc*>(&error) != nullptr ? "out of memory" : error.what();
    if (!ranks.meet(patience_s))
    {
        complain(fmt::format("rank {}: {}", ranks.rank(), message), status);
        ranks.abort(status);
    }
    if (ranks.is_root())
    {
        complain(message, status);
    }
    ranks.meet(patience_s); // one that leaves ends the others
    return status;
}

} // namespace

int run_command(RunArguments arguments)
{
    study::exit_when_interrupted();
    const std::unique_ptr<const Communicator> ranks = join_ranks();
    try
    {
        return run_on(*ranks, arguments);
    }
    catch (const std::exception& error)
    {
        if (ranks->size() == 1)
        {
            throw;
        }
        return end_together(*ranks, error);
    }
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/checkpointer.hpp"

#include "corticle/base/stopwatch.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/checkpointing.hpp"

namespace corticle::record
{

Checkpointer::Checkpointer(std::filesystem::path folder, std::string case_text, std::string versions, double minutes,
                           const metrics::Measuring& measuring, double& seconds)
    : folder_(std::move(folder)), case_text_(std::move(case_text)), versions_(std::move(versions)), minutes_(minutes),
      measuring_(measuring), seconds_(seconds), saved_at_(Clock::now())
{
}

bool Checkpointer::wants_state()
{
    is_due_ = std::chrono::duration<double>(Clock::now() - saved_at_).count() > 60.0 * minutes_;
    return is_due_;
}

void Checkpointer::on_step(const model::Simulation& simulation)
{
    if (is_due_)
    {
        save(simulation);
    }
}

void Checkpointer::on_end(const model::Simulation& simulation, model::RunStatus status)
{
    if (status == model::RunStatus::interrupted)
    {
        save(simulation);
    }
}

void Checkpointer::save(const model::Simulation& simulation)
{
    const Stopwatch watch(seconds_);
    // What the checkpoint counts as written must be there after a power cut.
    formats::flush_names(folder_ / "pictures");
    formats::flush_names(folder_);
    write_checkpoint(folder_ / "checkpoint.h5",
                     to_checkpoint(simulation.state(), measuring_.rows(), case_text_, versions_));
    saved_at_ = Clock::now();
}

} // namespace corticle::record

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/picture_observer.hpp"

#include "corticle/base/stopwatch.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/view/run_pictures.hpp"

#include <array>

namespace corticle::view
{

void PictureObserver::on_output(const model::OutputView& view)
{
    if (flags_.at(view.number))
    {
        const Stopwatch watch(recorder_.output_seconds());
        folder_.claim(record::frame_pictures(recorder_.frame().name));
        render_frame(folder_.path(), recorder_.frame());
    }
}

void PictureObserver::on_end(const model::Simulation& /*simulation*/, model::RunStatus status)
{
    if (status == model::RunStatus::completed)
    {
        const Stopwatch watch(recorder_.output_seconds());
        folder_.claim(std::array{std::string(record::measures_picture)});
        render_measures(folder_.path() / record::measures_picture, number_table(measuring_.rows()));
    }
}

} // namespace corticle::view

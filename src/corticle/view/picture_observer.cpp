// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/picture_observer.hpp"

#include "corticle/base/stopwatch.hpp"
#include "corticle/record/run_files.hpp"
#include "corticle/view/run_pictures.hpp"

#include <array>

namespace corticle
{

void PictureObserver::on_output(const OutputView& view)
{
    if (flags_.at(view.number))
    {
        const Stopwatch watch(recorder_.output_seconds());
        folder_.claim(frame_pictures(recorder_.frame().name));
        render_frame(folder_.path(), recorder_.frame());
    }
}

void PictureObserver::on_end(const Simulation& /*simulation*/, RunStatus status)
{
    if (status == RunStatus::completed)
    {
        const Stopwatch watch(recorder_.output_seconds());
        folder_.claim(std::array{std::string(measures_picture)});
        render_measures(folder_.path(), measuring_.rows());
    }
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/measuring.hpp"

#include "corticle/base/stopwatch.hpp"

namespace corticle::metrics
{

void Measuring::on_output(const model::OutputView& view)
{
    const Stopwatch watch(seconds_);
    arrays_ = surface_arrays(view);
    rows_.push_back(measure(view, arrays_));
}

} // namespace corticle::metrics

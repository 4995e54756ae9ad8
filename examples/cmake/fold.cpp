// SPDX-License-Identifier: GPL-3.0-or-later
// Folds a case under a weight and prints how its surface grows: the library without a run folder.
#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/metrics/measuring.hpp"
#include "corticle/model/simulation.hpp"
#include "corticle/prepare/prepare.hpp"
#include "corticle/record/run_files.hpp"

#include <algorithm>
#include <cstdio>

namespace
{

using namespace corticle;

/// A force alike on all particles, with the potential -f x.
class Weight final : public mechanics::ForceTerm
{
  public:
    explicit Weight(const Vec3& force) : force_(force) {}

    std::string_view name() const override { return "weight"; }
    mechanics::Contribution add(const mechanics::StepContext& context, std::span<Vec3> forces) override
    {
        potential_ = 0.0;
        for (std::size_t i = 0; i < forces.size(); ++i)
        {
            forces[i] += force_;
            potential_ -= dot(force_, context.x[i]);
        }
        return {};
    }
    std::vector<mechanics::NamedEnergy> energies() const override { return {{"weight", potential_}}; }

  private:
    Vec3 force_;
    double potential_ = 0.0;
};

void fold(const config::Options& options)
{
    const auto model = std::make_shared<const model::Model>(prepare::prepare_body(options).model);
    model::Simulation simulation(model, options);
    simulation.add_term(std::make_unique<Weight>(Vec3{0.0, 0.0, -1e-5}));
    metrics::Measuring measuring;
    model::Observer* const observers[]{&measuring};
    model::fold(simulation, record::output_times(options), 0, observers, [] { return false; });
    for (const metrics::Measures& row : measuring.rows())
    {
        std::printf("t %.3f  area %.3f mm2  hull index %.4f\n", row.t, row.area_mm2, row.gi_hull);
    }
}

} // namespace

int main(int argc, char** argv)
{
    try
    {
        const std::vector<std::string> overrides(argv + std::min(argc, 2), argv + argc);
        fold(config::read_case(argc > 1 ? argv[1] : "", overrides));
        return 0;
    }
    catch (const std::exception& error)
    {
        std::fprintf(stderr, "fold: %s\n", error.what());
        return 2;
    }
}

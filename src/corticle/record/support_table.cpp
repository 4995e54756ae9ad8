// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/support_table.hpp"

#include "corticle/formats/atomic_file.hpp"
#include "corticle/mechanics/boundary/support_term.hpp"

#include <fmt/format.h>

#include <charconv>
#include <fstream>

namespace corticle::record
{

namespace
{

constexpr std::string_view header = "t [-],support [-],nodes [-],displacement_x [mm],displacement_y [mm],"
                                    "displacement_z [mm],reaction_x [mu_w mm2],reaction_y [mu_w mm2],"
                                    "reaction_z [mu_w mm2]\n";

const boundary::SupportTerm* supports_of(const model::Simulation& simulation)
{
    for (const auto& term : simulation.terms())
    {
        if (const auto* supports = dynamic_cast<const boundary::SupportTerm*>(term.get()); supports != nullptr)
        {
            return supports;
        }
    }
    return nullptr;
}

} // namespace

SupportTable::SupportTable(const std::filesystem::path& folder, double reached)
    : file_(folder / support_table_name), text_(header)
{
    std::ifstream earlier(file_);
    std::string line;
    while (reached >= 0.0 && std::getline(earlier, line))
    {
        double t = 0.0;
        const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), t);
        if (error == std::errc{} && t <= reached)
        {
            text_ += line + "\n";
        }
    }
}

void SupportTable::on_output(const model::OutputView& view)
{
    const boundary::SupportTerm* supports = supports_of(view.simulation);
    if (supports == nullptr)
    {
        return;
    }
    for (std::size_t k = 0; k < supports->states().size(); ++k)
    {
        const auto& [nodes, u, force] = supports->states()[k];
        text_ += fmt::format("{:.17g},{},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", view.state().t, k + 1,
                             nodes, u.x, u.y, u.z, force.x, force.y, force.z);
    }
    formats::write_text_atomically(file_, text_);
}

} // namespace corticle::record

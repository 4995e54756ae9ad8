// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/expectations.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/config/toml_document.hpp"

#include <fmt/format.h>

#include <cmath>

namespace corticle
{

std::map<std::string, std::array<double, 2>> read_expectations(const std::filesystem::path& file)
{
    std::map<std::string, std::array<double, 2>> result;
    for (const TomlEntry& entry : parse_toml(read_case_text(file), file.string()))
    {
        if (entry.section != "expect" || entry.is_section)
        {
            continue;
        }
        const auto* range = std::get_if<std::vector<double>>(&entry.value);
        if (range == nullptr || range->size() != 2 || !std::isfinite((*range)[0]) || !std::isfinite((*range)[1]) ||
            (*range)[0] > (*range)[1])
        {
            throw InputError(fmt::format("{} ({}:{}): got {}, expected [low, high]", printable(entry.key),
                                         printable(file.string()), entry.line, describe(entry.value)));
        }
        result[entry.key.substr(entry.section.size() + 1)] = {(*range)[0], (*range)[1]};
    }
    return result;
}

} // namespace corticle

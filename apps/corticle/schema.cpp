// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/config/case_file.hpp"
#include "corticle/metrics/measure_table.hpp"

#include <fmt/format.h>

namespace corticle
{

int schema_command(const SchemaArguments& arguments)
{
    fmt::print("{}", arguments.measures   ? metrics::measures_markdown()
                     : arguments.markdown ? config::schema_markdown()
                                          : config::schema_text());
    return exit_status::done;
}

} // namespace corticle

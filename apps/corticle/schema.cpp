// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include <array>

#include "corticle/config/case_file.hpp"

#include <fmt/format.h>

namespace corticle
{

int schema_command(const SchemaArguments& arguments)
{
    fmt::print("{}", arguments.markdown ? schema_markdown() : schema_text());
    return exit_status::done;
}

} // namespace corticle

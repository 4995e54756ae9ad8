// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/starter.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace corticle
{

int new_command(const NewArguments& arguments)
{
    const std::string name = arguments.case_file.string();
    if (arguments.case_file.extension() != ".toml")
    {
        throw InputError(fmt::format("cannot write case: got {}, expected a name that ends in .toml", name));
    }
    const std::string text = starter_case(arguments.shape);
    std::FILE* file = std::fopen(name.c_str(), "wx"); // x: fails where the file exists
    if (file == nullptr)
    {
        throw InputError(fmt::format("cannot write case {}: {}", name,
                                     errno == EEXIST ? "it exists, and new never overwrites" : std::strerror(errno)));
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if ((std::fclose(file) != 0) || !written)
    {
        std::remove(name.c_str());
        throw RunError(fmt::format("cannot write case {}: the disk refused it", name));
    }
    fmt::print("wrote {}\n", name);
    return exit_status::done;
}

} // namespace corticle

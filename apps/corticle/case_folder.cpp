// SPDX-License-Identifier: GPL-3.0-or-later
#include "case_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_text.hpp"

namespace corticle
{

std::filesystem::path chosen_folder(const std::filesystem::path& out, const char* parent,
                                    const std::filesystem::path& case_file)
{
    if (out.empty() && config::is_standard_input(case_file))
    {
        throw InputError("--out is missing: got a case on the standard input, which has no name, expected a folder");
    }
    return out.empty() ? std::filesystem::path(parent) / case_file.stem() : out;
}

} // namespace corticle

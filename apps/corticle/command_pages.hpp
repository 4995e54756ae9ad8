// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command_line.hpp"

// What can be said of the command line from its own help: a manual page, and completions for shells.

namespace corticle
{

enum class CommandPage
{
    man, ///< man(7)
    bash,
    zsh,
    fish
};

template <>
inline std::vector<std::string> config::names<CommandPage>()
{
    return {"man", "bash", "zsh", "fish"};
}

/// An option or an argument of a verb.
struct DescribedOption
{
    std::string name; ///< "--out"; of an argument what stands for it: "CASE.toml"
    std::string form; ///< of its value: "DIR"; empty: a flag
    std::string meaning;
    std::string usual; ///< its default; empty: none, or the meaning says it
    std::vector<std::string> choices;
    bool is_many = false; ///< an argument that may be repeated
};

struct DescribedVerb
{
    std::string name, meaning;
    std::vector<DescribedOption> arguments;
    std::vector<DescribedOption> options;
};

std::vector<DescribedVerb> described_verbs(const CLI::App& app);

std::string manual_page(const CLI::App& app);
std::string bash_completion(const std::vector<DescribedVerb>& verbs);
std::string zsh_completion(const std::vector<DescribedVerb>& verbs);
std::string fish_completion(const std::vector<DescribedVerb>& verbs);

int command_page_command(const CLI::App& app, CommandPage page);

} // namespace corticle

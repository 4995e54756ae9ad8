// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "commands.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <functional>
#include <string>
#include <vector>

namespace corticle
{

/// What the command line chose to do; returns the exit status.
using Verb = std::function<int()>;

/// An option that is one of the names of an enumeration, as in cases.
template <class T>
CLI::Option* add_choice(CLI::App& verb, const std::string& name, T& chosen, const std::string& meaning)
{
    const std::vector<std::string> names = config::names<T>();
    const auto take = [&chosen, names](const std::string& word)
    { chosen = static_cast<T>(std::ranges::find(names, word) - names.begin()); };
    return verb.add_option_function<std::string>(name, take, meaning)
        ->check(CLI::IsMember(names))
        ->default_str(names[static_cast<std::size_t>(chosen)]);
}

// Verbs that show or hand on what runs left.
void add_render(CLI::App& app, Verb& chosen);
void add_report(CLI::App& app, Verb& chosen);
void add_export(CLI::App& app, Verb& chosen);

} // namespace corticle

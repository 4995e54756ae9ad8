// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_pages.hpp"

#include "corticle/config/parameters/parameters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace corticle
{

namespace
{

/// "section.key=" of every key that --set can change.
std::vector<std::string> settable()
{
    std::vector<std::string> keys;
    for (const config::Parameter& parameter : config::parameters())
    {
        if (!parameter.repeats())
        {
            keys.push_back(parameter.key + "=");
        }
    }
    return keys;
}

bool is_set(const DescribedOption& option)
{
    return option.name == "--set";
}

bool is_file(const DescribedOption& option)
{
    return option.form.find("DIR") != std::string::npos || option.form.find("FILE") != std::string::npos ||
           option.form == "BODY";
}

/// With a backslash before each of `special`.
std::string escaped(const std::string& text, std::string_view special)
{
    std::string made;
    for (const char c : text)
    {
        made += (special.find(c) == std::string_view::npos ? "" : "\\") + std::string(1, c);
    }
    return made;
}

/// In single quotes, as all three shells read them.
std::string quoted(const std::string& text)
{
    std::string made = "'";
    for (const char c : text)
    {
        made += c == '\'' ? std::string("'\\''") : std::string(1, c);
    }
    return made + "'";
}

std::vector<std::string> names_of(const std::vector<DescribedOption>& options)
{
    std::vector<std::string> names;
    for (const DescribedOption& option : options)
    {
        names.push_back(option.name);
    }
    return names;
}

/// zsh: '--map[meaning]:MAP:(fire ice)'.
std::string zsh_option(const DescribedOption& option)
{
    const std::string action = is_set(option)           ? "->key"
                               : option.choices.empty() ? is_file(option) ? "_files" : " "
                                                        : fmt::format("({})", fmt::join(option.choices, " "));
    const std::string value = option.form.empty() ? "" : fmt::format(":{}:{}", escaped(option.form, ":"), action);
    const bool may_repeat = is_set(option) || option.meaning.find("repeated") != std::string::npos;
    return quoted(fmt::format("{}{}[{}]{}", may_repeat ? "*" : "", option.name, escaped(option.meaning, "[]:"), value));
}

} // namespace

std::string bash_completion(const std::vector<DescribedVerb>& verbs)
{
    std::string text = "# bash completion of corticle, written by `corticle schema --of-command bash`\n"
                       "_corticle()\n{\n    local word=$2 verb=${COMP_WORDS[1]} words=\n    COMPREPLY=()\n";
    std::vector<std::string> names;
    std::string of_values;
    std::string of_verbs;
    for (const DescribedVerb& verb : verbs)
    {
        names.push_back(verb.name);
        of_verbs += fmt::format("        {}\\ -*) words={} ;;\n", verb.name,
                                quoted(fmt::format("{}", fmt::join(names_of(verb.options), " "))));
        for (const DescribedOption& option : verb.options)
        {
            if (!option.choices.empty())
            {
                of_values += fmt::format("        {}\\ {}) words={} ;;\n", verb.name, option.name,
                                         quoted(fmt::format("{}", fmt::join(option.choices, " "))));
            }
        }
    }
    text += fmt::format("    if [[ $COMP_CWORD == 1 ]]; then\n        words='{} --help --version'\n    fi\n",
                        fmt::join(names, " "));
    text += fmt::format(
        "    case \"$verb $3\" in\n        *\\ --set)\n            compopt -o nospace\n            words={}\n"
        "            ;;\n{}    esac\n",
        quoted(fmt::format("{}", fmt::join(settable(), " "))), of_values);
    text += fmt::format("    case \"$verb $word\" in\n{}    esac\n", of_verbs);
    return text +
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n}\ncomplete -o default -F _corticle corticle\n";
}

std::string zsh_completion(const std::vector<DescribedVerb>& verbs)
{
    std::string text =
        "#compdef corticle\n# zsh completion of corticle, written by `corticle schema --of-command zsh`\n"
        "_corticle()\n{\n    local context state line\n    local -a verbs keys\n    verbs=(\n";
    std::string of_verbs;
    for (const DescribedVerb& verb : verbs)
    {
        text += fmt::format("        {}\n", quoted(verb.name + ":" + verb.meaning));
        of_verbs += fmt::format("        {}) _arguments \\\n", verb.name);
        for (const DescribedOption& option : verb.options)
        {
            of_verbs += fmt::format("            {} \\\n", zsh_option(option));
        }
        of_verbs += "            '*:file:_files' ;;\n";
    }
    text +=
        "    )\n    if ((CURRENT == 2)); then\n        _describe -t verbs verb verbs\n"
        "        _arguments '--help[Show what the verbs do]' '--version[Show the version]'\n        return\n    fi\n"
        "    local verb=$words[2]\n    shift words\n    ((CURRENT--))\n";
    text += fmt::format("    case $verb in\n{}    esac\n", of_verbs);
    text += "    if [[ $state == key ]]; then\n        keys=(\n";
    for (const std::string& key : settable())
    {
        text += fmt::format("            {}\n", key);
    }
    return text + "        )\n        compadd -S '' -a keys\n    fi\n}\n_corticle \"$@\"\n";
}

std::string fish_completion(const std::vector<DescribedVerb>& verbs)
{
    std::string text = "# fish completion of corticle, written by `corticle schema --of-command fish`\n";
    for (const DescribedVerb& verb : verbs)
    {
        text += fmt::format("complete -c corticle -n __fish_use_subcommand -f -a {} -d {}\n", verb.name,
                            quoted(verb.meaning));
        const std::string head = fmt::format("complete -c corticle -n '__fish_seen_subcommand_from {}'", verb.name);
        for (const DescribedOption& option : verb.options)
        {
            const std::vector<std::string> words = is_set(option) ? settable() : option.choices;
            const std::string value = option.form.empty() ? ""
                                      : is_file(option)   ? " -r"
                                                          : fmt::format(" -x -a '{}'", fmt::join(words, " "));
            text += fmt::format("{} -l {}{} -d {}\n", head, option.name.substr(2), value, quoted(option.meaning));
        }
    }
    return text;
}

} // namespace corticle

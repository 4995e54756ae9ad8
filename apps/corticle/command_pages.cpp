// SPDX-License-Identifier: GPL-3.0-or-later
#include "command_pages.hpp"

#include "corticle/base/version.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace corticle
{

namespace
{

/// CLI11 writes the type of a choice as "MAP:{fire,ice}" and of a bounded number as "N:INT in [1 - 9]".
std::vector<std::string> choices_in(const std::string& type)
{
    const std::size_t open = type.find(":{");
    const std::size_t close = type.find('}', open);
    return open == std::string::npos ? std::vector<std::string>{}
                                     : CLI::detail::split(type.substr(open + 2, close - open - 2), ',');
}

DescribedOption described(const CLI::Option& option)
{
    const std::string type = option.get_type_name();
    const std::string form = option.get_type_size() == 0 ? "" : type.substr(0, type.find(':'));
    const bool is_argument = option.get_positional();
    return {.name = is_argument ? form : "--" + option.get_lnames().front(),
            .form = form,
            .meaning = option.get_description(),
            .usual = option.get_default_str(),
            .choices = choices_in(type),
            .is_many = is_argument && option.get_items_expected_max() > 1};
}

/// Text of a manual page: hyphens as typed, nothing taken for a request.
std::string troff(std::string_view text)
{
    std::string escaped;
    for (const char c : text)
    {
        escaped += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '.' && escaped.empty() ? "\\&." : std::string(1, c);
    }
    return escaped;
}

std::string manual_entry(const DescribedOption& option)
{
    const bool is_named = option.name != option.form;
    const std::string head = !is_named ? fmt::format(".I {}\n", troff(option.name))
                             : option.form.empty()
                                 ? fmt::format(".B {}\n", troff(option.name))
                                 : fmt::format(".BI {} \" {}\"\n", troff(option.name), troff(option.form));
    const std::string usual = option.usual.empty() ? "" : fmt::format(" (default: {})", option.usual);
    return fmt::format(".TP\n{}{}.\n", head, troff(option.meaning + usual));
}

std::string manual_section(const DescribedVerb& verb)
{
    std::string text = fmt::format(".SS corticle {}", verb.name);
    for (const DescribedOption& argument : verb.arguments)
    {
        text += fmt::format(" {}{}", troff(argument.name), argument.is_many ? " ..." : "");
    }
    text += fmt::format("\n{}.\n", troff(verb.meaning));
    for (const std::vector<DescribedOption>* options : {&verb.arguments, &verb.options})
    {
        for (const DescribedOption& option : *options)
        {
            text += manual_entry(option);
        }
    }
    return text;
}

/// What the help does not hold.
constexpr const char* manual_end = R"(.SH EXIT STATUS
.TP
.B 0
Done.
.TP
.B 2
Bad usage or input. One line says what, where, got and expected; nothing was written.
.TP
.B 3
The run failed. The line holds the diagnosis; the last good checkpoint is kept.
.TP
.B 130
Interrupted by a signal that asks it to end; a checkpoint was written.
.SH ENVIRONMENT
.TP
.B OMP_NUM_THREADS
Threads of a run without
.BR \-\-threads .
.TP
.B DISPLAY
X server for pictures; without it, Xvfb is started.
.TP
.B CORTICLE_TETRAHEDRALIZE
The program that makes tets, where it is not installed with the command.
.TP
.B CORTICLE_THREE_JS
Folder of three.js, for report.html (default: /usr/share/javascript/three).
.SH EXAMPLES
.EX
corticle new sphere.toml
corticle check sphere.toml
corticle run sphere.toml \-\-set geometry.particles=20000
corticle run sphere.toml \-\-resume
corticle export runs/sphere \-\-format gifti
.EE
)";

} // namespace

std::vector<DescribedVerb> described_verbs(const CLI::App& app)
{
    std::vector<DescribedVerb> verbs;
    for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; }))
    {
        DescribedVerb& made = verbs.emplace_back(DescribedVerb{verb->get_name(), verb->get_description(), {}, {}});
        for (const CLI::Option* option : verb->get_options())
        {
            (option->get_positional() ? made.arguments : made.options).push_back(described(*option));
        }
    }
    return verbs;
}

std::string manual_page(const CLI::App& app)
{
    const std::string version(program_version());
    std::string text =
        fmt::format(".TH CORTICLE 1 \"\" \"corticle {}\" \"User Commands\"\n"
                    ".SH NAME\ncorticle \\- meshless simulation of cortical folding\n"
                    ".SH SYNOPSIS\n.B corticle\n.I verb\n.RI [ argument \" ...] [\" option \" ...]\"\n"
                    ".SH DESCRIPTION\n"
                    "A growing cortex buckles on white matter that does not grow. A case, a file in TOML, says "
                    "what is\nfolded and how; a run of it leaves a folder of surfaces, measures, pictures and a "
                    "report.\n.SH VERBS\n",
                    version.substr(0, version.find(' ')));
    for (const DescribedVerb& verb : described_verbs(app))
    {
        text += manual_section(verb);
    }
    return text + manual_end;
}

int command_page_command(const CLI::App& app, CommandPage page)
{
    const std::vector<DescribedVerb> verbs = described_verbs(app);
    fmt::print("{}", page == CommandPage::man    ? manual_page(app)
                     : page == CommandPage::bash ? bash_completion(verbs)
                     : page == CommandPage::zsh  ? zsh_completion(verbs)
                                                 : fish_completion(verbs));
    return exit_status::done;
}

} // namespace corticle

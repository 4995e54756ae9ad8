// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/case_file.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/boundary_keys.hpp"
#include "corticle/config/case_checks.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/config/case_text.hpp"
#include "corticle/config/formulation_keys.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/config/thickness_keys.hpp"
#include "corticle/config/toml_document.hpp"
#include "corticle/config/week_keys.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace corticle::config
{

namespace
{

namespace fs = std::filesystem;

/// Gathers the keys of a case and of its overrides.
class CaseReader
{
  public:
    void read_text(std::string_view text, const std::string& name, const fs::path& base_directory);
    void read_overrides(std::span<const Override> overrides);
    Options finish();

  private:
    void assign_at(const std::string& key, const Value& value, const std::string& where, const fs::path& base);
    void forget(const std::string& key);
    void settle_alternatives();

    Options options_;
    std::map<std::string, std::string, std::less<>> places_; ///< where each key was given last
    std::set<std::string, std::less<>> overridden_;
};

InputError unknown_section(const std::string& section, const std::string& where)
{
    const std::string nearest = nearest_section(section);
    return InputError(fmt::format(
        "unknown section [{}] ({}); {}", printable(section), where,
        nearest.empty() ? "expected geometry, map, tissue, growth, solver, thesis, contact, time, size, output, "
                          "boundary, support, inputs or expect"
                        : "did you mean [" + nearest + "]?"));
}

bool is_section(std::string_view section)
{
    return std::ranges::any_of(parameters(), [&](const Parameter& p) { return p.section() == section; });
}

std::string trimmed(std::string_view text)
{
    const auto begin = text.find_first_not_of(" \t");
    return begin == std::string_view::npos ? ""
                                           : std::string(text.substr(begin, text.find_last_not_of(" \t") - begin + 1));
}

/// The value of an override: TOML, or a bare string.
Value override_value(const Parameter& parameter, const std::string& text)
{
    const bool wants_text = parameter.kind == Kind::text || parameter.kind == Kind::choice;
    const bool is_quoted = !text.empty() && (text.front() == '"' || text.front() == '\'');
    if (wants_text && !is_quoted)
    {
        return text;
    }
    return parse_toml_value(text).value_or(text);
}

void CaseReader::assign_at(const std::string& key, const Value& value, const std::string& where, const fs::path& base)
{
    const Parameter* parameter = find_parameter(key);
    if (parameter == nullptr)
    {
        throw unknown_key_error(key, where);
    }
    assign(options_, *parameter, value, where);
    places_[key] = where;
    const auto* text = std::get_if<std::string>(&value);
    if (parameter->is_path && text != nullptr && !text->empty())
    {
        if (text->find_first_of(std::string_view("\0\n\r", 3)) != std::string::npos)
        {
            throw InputError(fmt::format("{} ({}): got {}, expected a path in one line", key, where, describe(value)));
        }
        parameter->set(options_, fs::absolute(base / *text).lexically_normal().string());
    }
}

void CaseReader::read_text(std::string_view text, const std::string& name, const fs::path& base_directory)
{
    for (const TomlEntry& entry : parse_toml(text, name))
    {
        const std::string where = fmt::format("{}:{}", printable(name), entry.line);
        if (entry.section == "expect" || (entry.section == "inputs" && entry.is_section))
        {
            continue;
        }
        if (entry.section == "inputs")
        {
            assign_input(options_, entry.key.substr(entry.section.size() + 1), entry.value, where);
            continue;
        }
        if (entry.is_section && !is_section(entry.section))
        {
            throw unknown_section(entry.section, where);
        }
        if (!entry.is_section)
        {
            if (entry.section.empty() && (is_section(entry.key) || entry.key == "expect"))
            {
                throw InputError(fmt::format("{} ({}): got {}, expected a section: [{}]", entry.key, where,
                                             describe(entry.value), entry.key));
            }
            assign_at(entry.key, entry.value, where, base_directory);
        }
    }
}

/// "section.key=value" as it stands on the command line.
Override parse_override(const std::string& text)
{
    const auto equals = text.find('=');
    const std::string where = "--set " + printable(text);
    if (equals == std::string::npos)
    {
        throw InputError(fmt::format("--set: got \"{}\", expected section.key=value", printable(text)));
    }
    const std::string key = trimmed(std::string_view(text).substr(0, equals));
    const Parameter* parameter = find_parameter(key);
    if (parameter == nullptr)
    {
        throw unknown_key_error(key, where);
    }
    return {key, override_value(*parameter, trimmed(std::string_view(text).substr(equals + 1))), where};
}

/// Back to the value of a default-constructed Options.
void CaseReader::forget(const std::string& key)
{
    if (key == "geometry.spacing_mm")
    {
        options_.geometry.spacing_mm.reset();
    }
    else if (key == "geometry.particles")
    {
        options_.geometry.particles.reset();
    }
    else if (key == "solver.elements")
    {
        options_.elements.reset();
    }
    else
    {
        const Parameter* parameter = find_parameter(key);
        parameter->set(options_, parameter->get(Options{}));
    }
    places_.erase(key);
}

/// Of two keys that exclude each other an override beats what the file says.
void CaseReader::settle_alternatives()
{
    const auto replace = [&](const char* key, const char* other)
    {
        if (overridden_.contains(key) && !overridden_.contains(other))
        {
            forget(other);
        }
    };
    replace("geometry.spacing_mm", "geometry.particles");
    replace("geometry.spacing_mm", "solver.elements");
    replace("geometry.particles", "geometry.spacing_mm");
    replace("geometry.particles", "solver.elements");
    replace("solver.elements", "geometry.particles");
    replace("solver.elements", "geometry.spacing_mm");
    replace("output.count", "output.times");
    replace("output.count", "output.weeks");
    replace("output.weeks", "output.times");
    replace("output.times", "output.weeks");
    replace("time.start_week", "time.start");
    replace("time.end_week", "time.end");
    if (options_.tissue.thickness_preset != material::ThicknessPreset::none)
    {
        replace("tissue.thickness_preset", "tissue.thickness_mm");
        replace("tissue.thickness_preset", "tissue.thickness_rate_mm");
    }
}

void CaseReader::read_overrides(std::span<const Override> overrides)
{
    for (const Override& given : overrides)
    {
        assign_at(given.key, given.value, given.where, "");
        options_.inputs.erase(given.key); // of the file named before
        overridden_.insert(given.key);
    }
    settle_alternatives();
}

Options CaseReader::finish()
{
    prepare::GeometryOptions& geometry = options_.geometry;
    if (!geometry.spacing_mm && !geometry.particles && !options_.elements)
    {
        geometry.particles = prepare::default_particles;
    }
    const auto place = [&](std::string_view key)
    {
        const auto found = places_.find(key);
        return found == places_.end() ? std::string() : " (" + found->second + ")";
    };
    settle_formulation(options_, place);
    settle_weeks(options_, place);
    settle_thickness(options_.tissue, place);
    settle_supports(options_, place);
    settle_boundary(options_, place);
    check_case(options_, place);
    return options_;
}

/// Keys that a resumed run may not change.
bool matters_to_a_run(const Parameter& parameter)
{
    return parameter.section() != "output" && parameter.key != "time.end" && parameter.key != "time.end_week" &&
           parameter.key != "size.scaled";
}

bool matters_to_a_body(const Parameter& parameter)
{
    return parameter.section() == "geometry" || parameter.section() == "map" ||
           parameter.key.starts_with("tissue.labels.") || parameter.key == "solver.method" ||
           parameter.key == "solver.elements";
}

std::vector<std::string> differing(std::string_view resolved_a, std::string_view resolved_b,
                                   bool (*matters)(const Parameter&))
{
    const Options a = parse_case(resolved_a, "the first case", {}, "");
    const Options b = parse_case(resolved_b, "the second case", {}, "");
    const auto shown = [](const std::string& text) { return text.empty() ? std::string("not given") : text; };
    std::vector<std::string> result;
    for (const Parameter& parameter : parameters())
    {
        if (!matters(parameter))
        {
            continue;
        }
        const std::string value_a = toml_text(parameter.get(a));
        const std::string value_b = toml_text(parameter.get(b));
        const std::string difference = parameter.is_path ? input_difference(parameter, a, b)
                                       : value_a == value_b
                                           ? ""
                                           : fmt::format("{}: {} -> {}", parameter.key, shown(value_a), shown(value_b));
        if (!difference.empty())
        {
            result.push_back(difference);
        }
    }
    return result;
}

} // namespace

Options parse_case(std::string_view text, const std::string& name, std::span<const std::string> overrides,
                   const fs::path& base_directory)
{
    std::vector<Override> parsed;
    std::ranges::transform(overrides, std::back_inserter(parsed), parse_override);
    return parse_overridden_case(text, name, parsed, base_directory);
}

Options parse_overridden_case(std::string_view text, const std::string& name, std::span<const Override> overrides,
                              const fs::path& base_directory)
{
    CaseReader reader;
    reader.read_text(text, name, base_directory);
    reader.read_overrides(overrides);
    return reader.finish();
}

Options read_case(const fs::path& file, std::span<const std::string> overrides)
{
    return is_standard_input(file) ? parse_case(read_standard_input(), "standard input", overrides, "")
                                   : parse_case(read_case_text(file), file.string(), overrides, file.parent_path());
}

std::vector<std::string> differing_keys(std::string_view resolved_a, std::string_view resolved_b)
{
    return differing(resolved_a, resolved_b, matters_to_a_run);
}

std::vector<std::string> differing_body_keys(std::string_view resolved_a, std::string_view resolved_b)
{
    return differing(resolved_a, resolved_b, matters_to_a_body);
}

} // namespace corticle::config

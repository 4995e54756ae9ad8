// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/config/case_inputs.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/parameters/parameters.hpp"
#include "corticle/formats/companion_files.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::config
{

namespace
{

namespace fs = std::filesystem;

/// The file a parameter names; empty where it names none.
std::string file_of(const Parameter& parameter, const Options& options)
{
    const Value value = parameter.get(options);
    const auto* text = std::get_if<std::string>(&value);
    return parameter.is_path && text != nullptr ? *text : std::string();
}

std::string checksum_of(const Options& options, const std::string& key)
{
    const auto found = options.inputs.find(key);
    return found == options.inputs.end() ? std::string() : found->second;
}

/// The first digits of a checksum tell it from another as well as all of them.
std::string shortened(const std::string& checksum)
{
    return checksum.substr(0, 12);
}

bool is_checksum(const std::string& text)
{
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

std::string identify(const fs::path& file, KnownChecksums& known)
{
    std::error_code error;
    if (!fs::is_regular_file(file, error))
    {
        return {};
    }
    const auto [found, is_new] = known.try_emplace(file);
    if (is_new)
    {
        found->second = formats::sha256_with_companions(file);
    }
    return found->second;
}

} // namespace

void identify_inputs(Options& options, KnownChecksums& known)
{
    for (const Parameter& parameter : parameters())
    {
        const std::string file = file_of(parameter, options);
        const std::string now = file.empty() ? std::string() : identify(file, known);
        const std::string expected = checksum_of(options, parameter.key);
        if (!now.empty() && !expected.empty() && now != expected)
        {
            throw InputError(fmt::format("{}: {} is not the file that [inputs] of the case names: got SHA-256 {}..., "
                                         "expected {}... (without its line in [inputs] any content will do)",
                                         parameter.key, file, shortened(now), shortened(expected)));
        }
        options.inputs.erase(parameter.key);
        if (!now.empty())
        {
            options.inputs[parameter.key] = now;
        }
    }
}

void identify_inputs(Options& options)
{
    KnownChecksums known;
    identify_inputs(options, known);
}

void forget_names(Options& options)
{
    for (const auto& [key, checksum] : options.inputs)
    {
        find_parameter(key)->set(options, std::string());
    }
}

void assign_input(Options& options, const std::string& key, const Value& value, const std::string& where)
{
    const Parameter* parameter = find_parameter(key);
    if (parameter == nullptr || !parameter->is_path)
    {
        throw InputError(fmt::format("inputs ({}): got \"{}\", expected a key that names a file, such as "
                                     "\"geometry.file\"",
                                     where, printable(key)));
    }
    const auto* text = std::get_if<std::string>(&value);
    if (text == nullptr || !is_checksum(*text))
    {
        throw InputError(fmt::format("inputs \"{}\" ({}): got {}, expected a SHA-256 of 64 hexadecimal digits", key,
                                     where, describe(value)));
    }
    options.inputs[key] = *text;
}

std::string inputs_toml(const Options& options)
{
    std::string text;
    for (const auto& [key, checksum] : options.inputs)
    {
        text += fmt::format("\"{}\" = \"{}\"\n", key, checksum);
    }
    return text.empty() ? text : "\n[inputs]  # SHA-256 of the files that these keys name\n" + text;
}

std::string input_difference(const Parameter& parameter, const Options& a, const Options& b)
{
    const std::string file_a = file_of(parameter, a);
    const std::string file_b = file_of(parameter, b);
    const std::string checksum_a = checksum_of(a, parameter.key);
    const std::string checksum_b = checksum_of(b, parameter.key);
    const auto shown = [](const std::string& file) { return file.empty() ? std::string("not given") : file; };
    if (checksum_a.empty() || checksum_b.empty())
    {
        return file_a == file_b ? "" : fmt::format("{}: {} -> {}", parameter.key, shown(file_a), shown(file_b));
    }
    if (checksum_a == checksum_b)
    {
        return {};
    }
    const std::string sums = fmt::format("(SHA-256 {}... -> {}...)", shortened(checksum_a), shortened(checksum_b));
    return file_a == file_b ? fmt::format("{}: the content of {} has changed {}", parameter.key, file_a, sums)
                            : fmt::format("{}: {} -> {}, another content {}", parameter.key, file_a, file_b, sums);
}

} // namespace corticle::config

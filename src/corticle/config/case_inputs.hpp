// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/config/parameters/value.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

namespace corticle::config
{

struct Parameter;

/// Checksums of files that many cases name: each file is read once.
using KnownChecksums = std::map<std::filesystem::path, std::string>;

/// Sets Options::inputs to the checksums of the files that the case names. A file that cannot be read is left out: what
/// reads it says why.
/// @throws InputError where a file is not the one that Options::inputs, from an [inputs] table of the case, names
void identify_inputs(Options& options, KnownChecksums& known);
void identify_inputs(Options& options);

/// Takes the names of the files in Options::inputs out of the options: their content is left to tell them apart.
void forget_names(Options& options);

/// One line of an [inputs] table: the file of a key had this checksum.
/// @throws InputError for a key that names no file, or what is not a checksum; `where` ("case.toml:4") is in the
/// message
void assign_input(Options& options, const std::string& key, const Value& value, const std::string& where);

/// The [inputs] table of a resolved case; empty where no file is known.
std::string inputs_toml(const Options& options);

/// How the file of a parameter differs: "geometry.file: the content of brain.stl has changed (SHA-256 ... -> ...)";
/// empty where it is the same file by content or, where a checksum is missing, by name.
std::string input_difference(const Parameter& parameter, const Options& a, const Options& b);

} // namespace corticle::config

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/config/parameters/options.hpp"
#include "corticle/prepare/prepare.hpp"

#include <filesystem>

namespace corticle::record
{

/// Writes an arranged body and the case it was made from, whole or not at all. @throws RunError
void write_body(const std::filesystem::path& file, const prepare::Preparation& made, const config::Options& options);

/// An arranged body as write_body left it, bit for bit; connect_body makes it ready.
/// @throws InputError when it is not a body file, or was made from other keys of [geometry] or [map], or by another
/// method
prepare::Preparation read_body(const std::filesystem::path& file, const config::Options& options);

} // namespace corticle::record

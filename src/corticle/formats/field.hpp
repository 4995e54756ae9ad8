// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

namespace corticle::formats
{

/// A named array for an output file: `components` values per point (1 scalar, 3 vector, 9 tensor by rows).
struct Field
{
    std::string name;
    int components = 1;
    std::span<const double> values;
};

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace corticle::formats
{

/// Bytes of a number of a DataType of GIFTI; 0 for one that is not read.
std::size_t bytes_of_gifti(std::string_view type);

/// Numbers of such a type.
std::vector<double> gifti_numbers(std::string_view bytes, std::string_view type, bool big_endian);

} // namespace corticle::formats

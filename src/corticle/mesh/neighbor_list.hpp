// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

namespace corticle
{

/// Reference neighbours of every particle, itself excluded: those of particle i are
/// index[begin[i]] … index[begin[i+1]-1], in ascending order. The relation is symmetric.
struct Neighbors
{
    std::vector<std::int64_t> begin; ///< particles + 1 entries
    std::vector<std::int32_t> index;
};

} // namespace corticle

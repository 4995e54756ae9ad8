// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace corticle::material
{

/// Tissues that a label volume tells apart.
enum class TissueKind : std::uint8_t
{
    cortex, ///< cortical plate
    white,  ///< white matter: subplate, intermediate zone
    deep,   ///< deep grey matter
    ventricle,
    still ///< what does not grow
};

constexpr std::array tissue_names{"cortex", "white", "deep", "ventricle", "still"};
inline constexpr std::size_t tissue_count = tissue_names.size();
constexpr const char* name_of(TissueKind kind)
{
    return tissue_names[static_cast<std::size_t>(kind)];
}

/// A value for every tissue.
template <class T>
using PerTissue = std::array<T, tissue_count>;

} // namespace corticle::material

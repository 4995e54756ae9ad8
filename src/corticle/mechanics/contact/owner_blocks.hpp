// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

namespace corticle::contact
{

/// The owners of contact are worked out in blocks of so many.
inline constexpr std::int64_t owners_at_a_time = 256;

} // namespace corticle::contact

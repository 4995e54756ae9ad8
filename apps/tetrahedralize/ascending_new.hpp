// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace corticle
{

/// From here on, what `new` gives below 4 KiB has ascending addresses and is not given back by `delete`. For
/// a library whose results depend on the order of addresses: so they no longer depend on what was freed before. For one
/// thread, without a way back. Throws std::bad_alloc without address space.
void make_new_ascend();

} // namespace corticle

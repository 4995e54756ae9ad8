// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdio>
#include <string>

namespace corticle
{

/// Shows a text at once. Where the stream is closed, as after the hangup of a terminal, the text is lost and nothing
/// else: what goes on must not end because nobody watches.
inline void show(std::FILE* stream, const std::string& text)
{
    std::fwrite(text.data(), 1, text.size(), stream);
    std::fflush(stream);
}

} // namespace corticle

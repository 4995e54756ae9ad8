// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace corticle
{

inline constexpr int most_threads = 1024;

/// Why so many threads cannot be had; empty: they can. OpenMP would end the process, without a word to its caller. Only
/// more threads than processors are tried out.
std::string thread_shortage(int count);

/// @throws InputError for a number of threads in the environment (OMP_NUM_THREADS) that OpenMP would crash on
void require_thread_environment();

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/tlsph/particles.hpp"
#include "corticle/mesh/partition.hpp"

namespace corticle::tlsph
{

/// What a rank needs of the particles of a body: of its own all, of its ghosts where products of theirs are kept, of
/// all others reference position and volume. Particles keep their numbers; arrays have entries for all, of which those
/// of others are zero, and take no memory where they were never written.
Particles part_of(const Particles& all, const Partition& partition, int rank);

/// Calls act(array) for all arrays that differ from rank to rank, and act(number) for the numbers.
template <class Act>
void each_array(Particles& particles, Act&& act)
{
    PairBlocks& pairs = particles.pairs;
    act(pairs.block_size);
    act(pairs.begin);
    act(pairs.enriched_end);
    act(pairs.place);
    act(pairs.weight);
    act(pairs.table_begin);
    act(pairs.table);
    act(particles.correction);
    act(particles.weighted_sum);
    act(particles.enriched.reach);
    act(particles.enriched.group);
    act(particles.enriched.fits);
}

} // namespace corticle::tlsph

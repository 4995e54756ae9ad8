// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/communicator.hpp"
#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <cstdlib>

// Of a build without MPI.

namespace corticle
{

std::unique_ptr<const Communicator> join_ranks()
{
    const char* const started = std::getenv("OMPI_COMM_WORLD_SIZE");
    const int count = started != nullptr ? std::atoi(started) : 1;
    if (count > 1)
    {
        throw InputError(fmt::format("mpirun: got {} processes, expected 1: this build knows no MPI (`make mpi` makes "
                                     "one that does)",
                                     count));
    }
    return std::make_unique<const Communicator>();
}

} // namespace corticle

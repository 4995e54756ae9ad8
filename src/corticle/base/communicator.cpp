// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/communicator.hpp"

#include "corticle/base/error.hpp"

#include <cstdlib>

namespace corticle
{

void Communicator::abort(int status) const
{
    std::_Exit(status);
}

void at_root(const Communicator& ranks, const std::function<void()>& work)
{
    constexpr unsigned bad_input = 1;
    constexpr unsigned failed = 2;
    if (!ranks.is_root())
    {
        const unsigned flags = ranks.any(0);
        if ((flags & bad_input) != 0)
        {
            throw InputError("rank 0 refuses its input");
        }
        if ((flags & failed) != 0)
        {
            throw RunError("rank 0 has failed");
        }
        return;
    }
    try
    {
        work();
    }
    catch (const InputError&)
    {
        ranks.any(bad_input);
        throw;
    }
    catch (...)
    {
        ranks.any(failed);
        throw;
    }
    ranks.any(0);
}

const Communicator& alone()
{
    static const Communicator one;
    return one;
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "gate.hpp"

#include "corticle/base/parallel.hpp"

#include <unistd.h>

#include <atomic>

namespace corticle::python
{

namespace
{

// Of the process, as the threads of OpenMP are. Read and written with the GIL.
pid_t worked_in = 0;
int wanted_threads = 0;
std::atomic<int> works = 0;
std::atomic<bool> leaving = false;

[[noreturn]] void raise_runtime_error(const char* message)
{
    PyErr_SetString(PyExc_RuntimeError, message);
    throw py::error_already_set();
}

void require_own_threads()
{
    if (worked_in != 0 && worked_in != ::getpid())
    {
        raise_runtime_error("corticle has worked in the process that this one was forked from, and its threads are not "
                            "here; start processes with multiprocessing.get_context(\"spawn\")");
    }
    worked_in = ::getpid();
}

/// The interpreter ends: what of a daemon thread is still to do is not done.
[[noreturn]] void raise_exit()
{
    PyErr_SetNone(PyExc_SystemExit);
    throw py::error_already_set();
}

} // namespace

bool is_main_interpreter()
{
    const bool is_main = PyInterpreterState_Get() == PyInterpreterState_Main();
    if (!is_main)
    {
        PyErr_SetString(PyExc_ImportError,
                        "corticle works in the main interpreter of a process; expected no sub-interpreter");
    }
    return is_main;
}

Work::Work() : threads_before_(thread_count())
{
    if (leaving)
    {
        raise_exit();
    }
    require_own_threads();
    ++works;
    set_thread_count(wanted_threads);
    released_.emplace();
}

Work::~Work()
{
    released_.reset();
    set_thread_count(threads_before_);
    --works;
}

WorkIn::WorkIn(Activity& activity, bool moves) : activity_(activity), before_(activity)
{
    if (before_ == Activity::working)
    {
        raise_runtime_error("the simulation is stepping, in another thread or around this call; look at it between "
                            "steps, or from on_output");
    }
    if (before_ == Activity::showing && moves)
    {
        raise_runtime_error("the simulation is in the midst of run(): a callback can look at it, but not step it");
    }
    activity_ = Activity::working;
    try
    {
        work_.emplace();
    }
    catch (...)
    {
        activity_ = before_;
        throw;
    }
}

WorkIn::~WorkIn()
{
    work_.reset();
    activity_ = before_;
}

Poll::~Poll()
{
    const py::gil_scoped_acquire locked;
    tell_ = py::object();
}

void Poll::operator()(double t, std::int64_t steps)
{
    constexpr auto interval = std::chrono::milliseconds(50);
    if (Clock::now() - last_ < interval && !leaving)
    {
        return;
    }
    const py::gil_scoped_acquire locked;
    if (leaving)
    {
        raise_exit();
    }
    if (PyErr_CheckSignals() != 0)
    {
        throw py::error_already_set();
    }
    if (!tell_.is_none())
    {
        tell_(t, steps);
    }
    last_ = Clock::now();
}

void leave()
{
    constexpr auto patience = std::chrono::seconds(60); // of callbacks that do not come back
    leaving = true;
    if (worked_in != ::getpid())
    {
        return;
    }
    const py::gil_scoped_release released;
    const auto began = std::chrono::steady_clock::now();
    while (works > 0 && std::chrono::steady_clock::now() - began < patience)
    {
        ::usleep(1000);
    }
}

void choose_threads(int count)
{
    wanted_threads = count;
}

int chosen_threads()
{
    return wanted_threads > 0 ? wanted_threads : thread_count();
}

} // namespace corticle::python

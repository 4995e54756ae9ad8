// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>

// Work without the interpreter lock (GIL): who may do it when, with how many threads.

namespace corticle::python
{

namespace py = pybind11;

/// Whether this is the main interpreter of the process; else ImportError is set: threads that have worked come back to
/// that one alone. Of Python's own API only, as pybind11 itself waits for ever in another interpreter.
bool is_main_interpreter();

/// Whether an object is being worked in. Changes only while the GIL is held.
enum class Activity
{
    none,
    showing, ///< its work has stopped for a Python callback, which may look at it
    working
};

/// Work for as long as it lives: the GIL is released, and the chosen number of threads is set for the calling thread.
/// @throws py::error_already_set: RuntimeError in a forked child of a process that has worked, where the threads of
/// OpenMP do not live on; SystemExit while the interpreter ends
class Work
{
  public:
    Work();
    ~Work();
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

  private:
    int threads_before_;
    std::optional<py::gil_scoped_release> released_;
};

/// Work in an object. @throws RuntimeError where somebody works in it already
class WorkIn
{
  public:
    /// @param moves  whether the object changes: not from within a callback of its own
    WorkIn(Activity& activity, bool moves);
    ~WorkIn();
    WorkIn(const WorkIn&) = delete;
    WorkIn& operator=(const WorkIn&) = delete;

  private:
    Activity& activity_;
    Activity before_;
    std::optional<Work> work_;
};

/// A Python callback in the midst of the work in an object.
class Showing
{
  public:
    explicit Showing(Activity& activity) : activity_(activity) { activity_ = Activity::showing; }
    ~Showing() { activity_ = Activity::working; }
    Showing(const Showing&) = delete;
    Showing& operator=(const Showing&) = delete;

  private:
    py::gil_scoped_acquire locked_; // first in, last out
    Activity& activity_;
};

/// Looks after Ctrl-C while steps are taken, and tells of progress, now and then. Call without the GIL.
class Poll
{
  public:
    /// @param tell  Python callable or None
    explicit Poll(py::object tell) : tell_(std::move(tell)) {}
    ~Poll();
    Poll(const Poll&) = delete;
    Poll& operator=(const Poll&) = delete;

    /// @throws py::error_already_set for KeyboardInterrupt, or what the callable raises
    void operator()(double t, std::int64_t steps);

  private:
    using Clock = std::chrono::steady_clock;
    py::object tell_;
    Clock::time_point last_ = Clock::now();
};

/// Ends the work of all threads and waits for it: for the end of the interpreter, which their threads must not meet.
void leave();

/// Threads of the work from now on; 0: as OpenMP has it, all cores.
void choose_threads(int count);
int chosen_threads();

} // namespace corticle::python

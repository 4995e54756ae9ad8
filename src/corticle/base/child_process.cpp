// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/child_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <new>
#include <system_error>
#include <utility>

namespace corticle
{

namespace
{

// Exit statuses of the child.
constexpr int failed = 1;
constexpr int out_of_memory = 2;

bool write_all(int file, const std::string& bytes)
{
    std::size_t done = 0;
    while (done < bytes.size())
    {
        const ssize_t count = write(file, bytes.data() + done, bytes.size() - done);
        if (count < 0 && errno != EINTR)
        {
            return false;
        }
        done += count > 0 ? static_cast<std::size_t>(count) : 0;
    }
    return true;
}

std::string read_all(int file)
{
    std::string bytes;
    std::array<char, 65536> buffer;
    for (;;)
    {
        const ssize_t count = read(file, buffer.data(), buffer.size());
        if (count == 0 || (count < 0 && errno != EINTR))
        {
            return bytes;
        }
        bytes.append(buffer.data(), count > 0 ? static_cast<std::size_t>(count) : 0);
    }
}

[[noreturn]] void be_the_child(int out, pid_t parent, const std::function<std::string()>& work)
{
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != parent)
    {
        _exit(failed); // the parent ended before the line above
    }
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    int status = failed;
    try
    {
        status = write_all(out, work()) ? 0 : failed;
    }
    catch (const std::bad_alloc&)
    {
        status = out_of_memory;
    }
    catch (...)
    {
        status = failed;
    }
    _exit(status); // nothing of the parent is flushed or destroyed twice
}

/// The exit status; negative where a signal ended the child, or nothing is known of its end.
int status_of(pid_t child)
{
    int status = 0;
    pid_t waited = waitpid(child, &status, 0);
    while (waited < 0 && errno == EINTR)
    {
        waited = waitpid(child, &status, 0);
    }
    return waited == child && WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

WaitableChildren::WaitableChildren()
{
    struct sigaction action
    {
    };
    action.sa_handler = SIG_DFL;
    sigemptyset(&action.sa_mask);
    sigaction(SIGCHLD, nullptr, &found_);
    if (found_.sa_handler == SIG_IGN || (found_.sa_flags & SA_NOCLDWAIT) != 0)
    {
        sigaction(SIGCHLD, &action, nullptr);
    }
}

WaitableChildren::~WaitableChildren()
{
    sigaction(SIGCHLD, &found_, nullptr);
}

std::optional<std::string> in_child_process(const std::function<std::string()>& work)
{
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
    {
        throw std::system_error(errno, std::generic_category(), "pipe");
    }
    const WaitableChildren waitable;
    std::fflush(nullptr);
    const pid_t parent = getpid();
    const pid_t child = fork();
    if (child == 0)
    {
        close(ends[0]);
        be_the_child(ends[1], parent, work);
    }
    const int fork_error = errno;
    close(ends[1]);
    std::string bytes = child > 0 ? read_all(ends[0]) : std::string{};
    close(ends[0]);
    if (child < 0)
    {
        throw std::system_error(fork_error, std::generic_category(), "fork");
    }
    const int status = status_of(child);
    if (status == out_of_memory)
    {
        throw std::bad_alloc();
    }
    return status == 0 ? std::optional(std::move(bytes)) : std::nullopt;
}

} // namespace corticle

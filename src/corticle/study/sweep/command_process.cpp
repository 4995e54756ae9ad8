// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/command_process.hpp"

#include "corticle/base/error.hpp"
#include "corticle/study/interruption.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace corticle::sweep
{

namespace
{

constexpr off_t most_output = 4096; // [bytes]
constexpr int not_started = 127;
constexpr int unknown_status = 255; ///< somebody else has waited for the process

/// In the child, where only calls are allowed that are safe in a signal handler. Never returns.
[[noreturn]] void become(char* const* words, int output, pid_t parent, const sigset_t& signals)
{
    setpgid(0, 0);
    prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (getppid() != parent)
    {
        _exit(not_started); // the parent ended before the line above
    }
    const int nothing = open("/dev/null", O_RDONLY);
    dup2(nothing, STDIN_FILENO);
    dup2(output, STDOUT_FILENO);
    dup2(output, STDERR_FILENO);
    study::reset_interrupting_signals();
    sigprocmask(SIG_SETMASK, &signals, nullptr);
    execv(words[0], words);
    _exit(not_started);
}

std::string end_of(int file)
{
    const off_t size = lseek(file, 0, SEEK_END);
    const off_t kept = std::clamp<off_t>(size, 0, most_output);
    std::string text(static_cast<std::size_t>(kept), '\0');
    const ssize_t read = pread(file, text.data(), text.size(), size - kept);
    text.resize(read < 0 ? 0 : static_cast<std::size_t>(read));
    return text;
}

} // namespace

CommandProcess::CommandProcess(const std::vector<std::string>& words) : output_(memfd_create("output", MFD_CLOEXEC))
{
    std::vector<char*> pointers;
    for (const std::string& word : words)
    {
        pointers.push_back(const_cast<char*>(word.c_str())); // execv changes none of them
    }
    pointers.push_back(nullptr);
    const pid_t parent = getpid();
    sigset_t all;
    sigset_t before;
    sigfillset(&all);
    sigprocmask(SIG_SETMASK, &all, &before); // no signal is to reach the handlers of this process in the child
    id_ = output_ < 0 ? -1 : fork();
    if (id_ == 0)
    {
        become(pointers.data(), output_, parent, before);
    }
    sigprocmask(SIG_SETMASK, &before, nullptr);
    if (id_ < 0)
    {
        const std::string reason = std::generic_category().message(errno);
        if (output_ >= 0)
        {
            close(output_);
        }
        throw RunError(fmt::format("cannot start {}: {}", words.front(), reason));
    }
}

CommandProcess::CommandProcess(CommandProcess&& other) noexcept
    : id_(std::exchange(other.id_, -1)), output_(std::exchange(other.output_, -1))
{
}

CommandProcess& CommandProcess::operator=(CommandProcess&& other) noexcept
{
    std::swap(id_, other.id_);
    std::swap(output_, other.output_);
    return *this;
}

CommandProcess::~CommandProcess()
{
    if (id_ > 0)
    {
        kill(id_, SIGKILL);
        waitpid(id_, nullptr, 0);
    }
    if (output_ >= 0)
    {
        close(output_);
    }
}

std::optional<ProcessEnd> CommandProcess::poll()
{
    int status = 0;
    const pid_t ended = id_ <= 0 ? 0 : waitpid(id_, &status, WNOHANG);
    if (ended == 0 || (ended < 0 && errno == EINTR))
    {
        return std::nullopt;
    }
    id_ = -1;
    ProcessEnd end;
    end.signal = ended > 0 && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.status = ended < 0 ? unknown_status : WIFEXITED(status) ? WEXITSTATUS(status) : 0;
    end.output = end_of(output_);
    return end;
}

void CommandProcess::terminate() const
{
    if (id_ > 0)
    {
        kill(id_, SIGTERM);
    }
}

} // namespace corticle::sweep

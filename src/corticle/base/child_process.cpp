// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/child_process.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <system_error>

#include <fcntl.h>
#include <spawn.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

namespace corticle
{

namespace
{

constexpr int unknown_status = 255; ///< somebody else has waited for the process

/// A file in memory: unlike the ends of pipes, neither process waits for the other to read or write it.
class MemoryFile
{
  public:
    explicit MemoryFile(std::string_view content = {})
    {
        const int first = memfd_create("exchange", MFD_CLOEXEC);
        file_ = fcntl(first, F_DUPFD_CLOEXEC, STDERR_FILENO + 1); // none of those it is to replace
        close(first);
        if (file_ < 0 || !write(content))
        {
            const int reason = errno;
            close(file_);
            throw std::system_error(reason, std::generic_category(), "memory for a program's input");
        }
    }
    ~MemoryFile() { close(file_); }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;

    int number() const { return file_; }
    std::string content() const
    {
        std::string bytes(static_cast<std::size_t>(lseek(file_, 0, SEEK_END)), '\0');
        std::size_t done = 0;
        while (done < bytes.size())
        {
            const ssize_t count = pread(file_, bytes.data() + done, bytes.size() - done, static_cast<off_t>(done));
            if (count <= 0)
            {
                break;
            }
            done += static_cast<std::size_t>(count);
        }
        bytes.resize(done);
        return bytes;
    }

  private:
    bool write(std::string_view content) const
    {
        while (!content.empty())
        {
            const ssize_t count = ::write(file_, content.data(), content.size());
            if (count <= 0)
            {
                return false;
            }
            content.remove_prefix(static_cast<std::size_t>(count));
        }
        return lseek(file_, 0, SEEK_SET) == 0;
    }

    int file_ = -1;
};

/// 0, or the error.
int spawn(const std::vector<std::string>& words, const MemoryFile& input, const MemoryFile& output,
          const MemoryFile& errors, pid_t& child)
{
    std::vector<char*> pointers;
    for (const std::string& word : words)
    {
        pointers.push_back(const_cast<char*>(word.c_str())); // nobody changes them
    }
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_adddup2(&files, input.number(), STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&files, output.number(), STDOUT_FILENO);
    posix_spawn_file_actions_adddup2(&files, errors.number(), STDERR_FILENO);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);
    const int error = posix_spawn(&child, pointers[0], &files, &attributes, pointers.data(), environ);
    posix_spawnattr_destroy(&attributes);
    posix_spawn_file_actions_destroy(&files);
    return error;
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

ProcessEnd run_program(const std::vector<std::string>& words, std::string_view input)
{
    const WaitableChildren waitable;
    const MemoryFile in(input);
    const MemoryFile out;
    const MemoryFile errors;
    pid_t child = -1;
    if (const int error = spawn(words, in, out, errors, child); error != 0)
    {
        throw RunError(fmt::format("cannot start {}: {}", words.front(), std::generic_category().message(error)));
    }
    int status = 0;
    pid_t waited = -1;
    do
    {
        waited = waitpid(child, &status, 0);
    } while (waited < 0 && errno == EINTR);
    ProcessEnd end;
    end.signal = waited == child && WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    end.status = waited == child && WIFEXITED(status) ? WEXITSTATUS(status) : unknown_status;
    end.output = out.content();
    end.errors = errors.content();
    return end;
}

} // namespace corticle

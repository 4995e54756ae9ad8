// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/child_process.hpp"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <system_error>

namespace corticle
{

namespace
{

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

[[noreturn]] void be_the_child(int out, const std::function<std::string()>& work)
{
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    dup2(nowhere, STDERR_FILENO);
    bool done = false;
    try
    {
        done = write_all(out, work());
    }
    catch (...)
    {
        done = false;
    }
    _exit(done ? 0 : 1); // nothing of the parent is flushed or destroyed twice
}

} // namespace

std::optional<std::string> in_child_process(const std::function<std::string()>& work)
{
    std::array<int, 2> ends;
    if (pipe2(ends.data(), O_CLOEXEC) != 0)
    {
        throw std::system_error(errno, std::generic_category(), "pipe");
    }
    std::fflush(nullptr);
    const pid_t child = fork();
    if (child == 0)
    {
        close(ends[0]);
        be_the_child(ends[1], work);
    }
    const int fork_error = errno;
    close(ends[1]);
    std::string bytes = child > 0 ? read_all(ends[0]) : std::string{};
    close(ends[0]);
    if (child < 0)
    {
        throw std::system_error(fork_error, std::generic_category(), "fork");
    }
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR)
    {
    }
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0)
    {
        return std::nullopt;
    }
    return bytes;
}

} // namespace corticle

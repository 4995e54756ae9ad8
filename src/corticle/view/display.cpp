// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/display.hpp"

#include "corticle/base/error.hpp"
#include "corticle/view/pictures.hpp"

#include <fmt/format.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>

#include <dlfcn.h>
#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace corticle::view
{

namespace
{

constexpr const char* advice = "set DISPLAY to an X server with GLX, or install Xvfb (Debian: apt install xvfb)";
constexpr std::chrono::seconds start_timeout{20};

/// The few calls of libX11 needed here. VTK loads the library anyhow.
class XLibrary
{
  public:
    XLibrary() : library_(::dlopen("libX11.so.6", RTLD_NOW | RTLD_GLOBAL)) {}

    /// A connection to a display that can draw, nullptr when there is none. It is never closed: an open connection
    /// keeps Xvfb from resetting itself between two pictures.
    void* connect(const char* display) const
    {
        const auto open = find<void* (*)(const char*)>("XOpenDisplay");
        const auto query = find<int (*)(void*, const char*, int*, int*, int*)>("XQueryExtension");
        if (open == nullptr || query == nullptr)
        {
            return nullptr;
        }
        void* connection = open(display);
        std::array<int, 3> ignored{};
        const bool draws =
            connection != nullptr && query(connection, "GLX", &ignored[0], &ignored[1], &ignored[2]) != 0;
        return draws ? connection : nullptr;
    }

  private:
    template <class Function>
    Function find(const char* name) const
    {
        return library_ == nullptr ? nullptr : reinterpret_cast<Function>(::dlsym(library_, name));
    }

    void* library_;
};

/// What the child does between fork and exec: only calls that are safe there.
[[noreturn]] void become_xvfb(int display_fd, pid_t parent, const char* const* arguments)
{
    constexpr int kept = 3;
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (::getppid() != parent || ::dup2(display_fd, kept) < 0)
    {
        ::_exit(127);
    }
    ::fcntl(kept, F_SETFD, 0); // dup2 onto itself keeps close-on-exec
    ::setsid();                // an interrupt from the keyboard is for the program alone
    sigset_t none;
    ::sigemptyset(&none);
    ::sigprocmask(SIG_SETMASK, &none, nullptr);
    const int nowhere = ::open("/dev/null", O_RDWR);
    for (int fd = 0; fd < kept; ++fd)
    {
        ::dup2(nowhere, fd);
    }
    ::close_range(kept + 1, ~0U, 0);
    ::execvp(arguments[0], const_cast<char* const*>(arguments));
    ::_exit(127);
}

/// An X server in memory that lives as long as this object.
class Xvfb
{
  public:
    Xvfb() = default;
    Xvfb(const Xvfb&) = delete;
    Xvfb& operator=(const Xvfb&) = delete;
    ~Xvfb()
    {
        if (owner_ == ::getpid())
        {
            stop();
        }
    }

    /// The display of a server started now, ":7" for instance; empty when it could not be started.
    std::string start()
    {
        std::array<int, 2> ends{};
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
        {
            return {};
        }
        constexpr std::array<const char*, 12> arguments{"Xvfb",      "-displayfd", "3",          "-screen",
                                                        "0",         "64x64x24",   "+extension", "GLX",
                                                        "-nolisten", "tcp",        "-terminate", nullptr};
        const pid_t parent = ::getpid();
        const pid_t child = ::fork();
        if (child == 0)
        {
            become_xvfb(ends[1], parent, arguments.data());
        }
        ::close(ends[1]);
        if (child > 0)
        {
            child_ = child;
            owner_ = parent;
        }
        const std::string number = child > 0 ? read_number(ends[0]) : std::string{};
        ::close(ends[0]);
        if (number.empty() && child > 0)
        {
            stop();
        }
        return number.empty() ? number : ":" + number;
    }

  private:
    /// Xvfb writes its number and a line end once it is ready; the pipe closes when it fails.
    static std::string read_number(int fd)
    {
        const auto deadline = std::chrono::steady_clock::now() + start_timeout;
        std::string text;
        while (text.empty() || text.back() != '\n')
        {
            const auto left =
                std::chrono::duration_cast<std::chrono::milliseconds>(deadline - std::chrono::steady_clock::now());
            pollfd waiting{fd, POLLIN, 0};
            const int ready = left.count() > 0 ? ::poll(&waiting, 1, static_cast<int>(left.count())) : 0;
            if (ready < 0 && errno == EINTR)
            {
                continue;
            }
            std::array<char, 16> buffer{};
            const ssize_t got = ready > 0 ? ::read(fd, buffer.data(), buffer.size()) : 0;
            if (got <= 0)
            {
                return {};
            }
            text.append(buffer.data(), static_cast<std::size_t>(got));
        }
        text.pop_back();
        return text;
    }

    void stop()
    {
        ::kill(child_, SIGTERM);
        for (int i = 0; i < 200; ++i)
        {
            if (::waitpid(child_, nullptr, WNOHANG) != 0)
            {
                owner_ = 0;
                return;
            }
            ::usleep(10'000);
        }
        ::kill(child_, SIGKILL);
        ::waitpid(child_, nullptr, 0);
        owner_ = 0;
    }

    pid_t child_ = 0;
    pid_t owner_ = 0;
};

/// Why nothing can be drawn; empty when something can.
std::string find_or_start_display()
{
    const XLibrary x;
    const char* named = std::getenv("DISPLAY");
    if (named != nullptr && *named != '\0' && x.connect(named) != nullptr)
    {
        return {};
    }
    // One X server serves the whole process, and must outlive every picture: it ends with the process.
    static Xvfb server;
    ::setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
    const std::string display = server.start();
    if (display.empty())
    {
        return fmt::format("no display, and Xvfb did not start: {}", advice);
    }
    if (x.connect(display.c_str()) == nullptr)
    {
        return fmt::format("Xvfb runs on {} but offers no GLX: {}", display, advice);
    }
    ::setenv("DISPLAY", display.c_str(), 1);
    return {};
}

} // namespace

bool ensure_display(std::string& reason)
{
    static const std::string missing = find_or_start_display();
    reason = missing;
    return missing.empty();
}

bool can_render(std::string& reason)
{
    return ensure_display(reason);
}

void require_display(const std::filesystem::path& png)
{
    std::string reason;
    if (!ensure_display(reason))
    {
        throw RunError(fmt::format("cannot draw {}: {}", png.string(), reason));
    }
}

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/atomic_file.hpp"

#include "corticle/base/error.hpp"

#include <fmt/format.h>

#include <atomic>
#include <cerrno>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace corticle::formats
{

namespace
{

std::string reason_of(int code)
{
    return std::generic_category().message(code);
}

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& reason)
{
    throw RunError(fmt::format("cannot write {}: {}", file.string(), reason));
}

/// A file descriptor that closes itself.
class Descriptor
{
  public:
    Descriptor(const std::filesystem::path& path, int flags) : fd_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    ~Descriptor()
    {
        if (fd_ >= 0)
        {
            ::close(fd_);
        }
    }
    int get() const { return fd_; }

    /// Closes now; false, with errno set, when the system could not keep what was written.
    bool close()
    {
        const int fd = fd_;
        fd_ = -1;
        return ::close(fd) == 0;
    }

  private:
    int fd_;
};

/// A name in the same folder that no other process or thread uses.
std::filesystem::path temporary_beside(const std::filesystem::path& file)
{
    static std::atomic<unsigned> counter{0};
    const auto name = fmt::format(".{}.{}-{}.tmp", file.filename().string(), ::getpid(), counter.fetch_add(1));
    return file.parent_path() / name;
}

void flush_to_disk(const std::filesystem::path& file, const std::filesystem::path& temporary)
{
    Descriptor descriptor(temporary, O_RDONLY);
    if (descriptor.get() < 0 || ::fsync(descriptor.get()) != 0)
    {
        fail(file, reason_of(errno));
    }
}

void write_all(const std::filesystem::path& file, const std::filesystem::path& temporary, std::string_view text)
{
    Descriptor descriptor(temporary, O_WRONLY | O_CREAT | O_TRUNC);
    if (descriptor.get() < 0)
    {
        fail(file, reason_of(errno));
    }
    while (!text.empty())
    {
        const ssize_t written = ::write(descriptor.get(), text.data(), text.size());
        if (written < 0 && errno == EINTR)
        {
            continue;
        }
        if (written <= 0)
        {
            fail(file, reason_of(written < 0 ? errno : ENOSPC));
        }
        text.remove_prefix(static_cast<std::size_t>(written));
    }
    if (!descriptor.close())
    {
        fail(file, reason_of(errno));
    }
}

} // namespace

void write_atomically(const std::filesystem::path& file, const std::function<void(const std::filesystem::path&)>& write)
{
    const std::filesystem::path temporary = temporary_beside(file);
    try
    {
        write(temporary);
        flush_to_disk(file, temporary);
        if (::rename(temporary.c_str(), file.c_str()) != 0)
        {
            fail(file, reason_of(errno));
        }
    }
    catch (const RunError&)
    {
        ::unlink(temporary.c_str());
        throw;
    }
    catch (const std::bad_alloc&)
    {
        ::unlink(temporary.c_str());
        throw;
    }
    catch (const std::exception& error)
    {
        ::unlink(temporary.c_str());
        fail(file, error.what());
    }
}

std::string target_of_temporary(std::string_view name)
{
    const auto is_number = [](std::string_view text)
    { return !text.empty() && text.find_first_not_of("0123456789") == std::string_view::npos; };
    constexpr std::string_view end = ".tmp";
    if (!name.starts_with('.') || !name.ends_with(end))
    {
        return {};
    }
    name = name.substr(1, name.size() - 1 - end.size());
    const std::size_t dot = name.rfind('.');
    const std::size_t dash = name.rfind('-');
    const bool is_ours = dot != std::string_view::npos && dash != std::string_view::npos && dash > dot &&
                         is_number(name.substr(dot + 1, dash - dot - 1)) && is_number(name.substr(dash + 1));
    return is_ours ? std::string(name.substr(0, dot)) : std::string();
}

void flush_names(const std::filesystem::path& folder)
{
    Descriptor descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
    if (descriptor.get() >= 0)
    {
        ::fsync(descriptor.get());
    }
}

void write_text_atomically(const std::filesystem::path& file, std::string_view text)
{
    write_atomically(file, [&](const std::filesystem::path& temporary) { write_all(file, temporary, text); });
}

} // namespace corticle::formats

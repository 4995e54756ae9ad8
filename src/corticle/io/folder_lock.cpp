// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/io/folder_lock.hpp"

#include "corticle/base/error.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>

namespace corticle
{

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (descriptor_ >= 0 && flock(descriptor_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK)
    {
        close(descriptor_);
        throw InputError(fmt::format("--out {}: another process is writing a run there; expected a folder of its own",
                                     folder.string()));
    }
}

FolderLock::~FolderLock()
{
    if (descriptor_ >= 0)
    {
        close(descriptor_);
    }
}

} // namespace corticle

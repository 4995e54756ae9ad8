// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace corticle
{

/// Keeps other processes from writing into a folder for as long as it lives (flock on the folder itself: it ends with
/// the process, however that ends). Where the file system knows no such locks, it does nothing.
class FolderLock
{
  public:
    /// @throws InputError when another process holds the folder
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

  private:
    int descriptor_;
};

} // namespace corticle

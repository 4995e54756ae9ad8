// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>

namespace corticle::record
{

/// Keeps other processes from writing into a folder for as long as it lives (flock on the folder itself: it ends with
/// the process, however that ends). Where the file system knows no such locks, it does nothing.
class FolderLock
{
  public:
    /// Nothing when another process holds the folder.
    static std::optional<FolderLock> try_lock(const std::filesystem::path& folder);

    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&& other) noexcept;
    ~FolderLock();

  private:
    explicit FolderLock(int descriptor) : descriptor_(descriptor) {}

    int descriptor_;
};

} // namespace corticle::record

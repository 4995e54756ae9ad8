// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/record/folder_lock.hpp"

#include <set>
#include <span>
#include <string>

namespace corticle::record
{

/// A folder that a command writes its results to. A list in it (corticle-files.txt) names the files that the program
/// wrote there. What the list does not name is somebody else's: it is never replaced or removed, whatever its name.
/// The folder is locked before the list is read, and for as long as the object lives.
class ResultFolder
{
  public:
    static constexpr const char* list_name = "corticle-files.txt";

    /// Writes nothing.
    /// @param kind    what the folder holds: "run", "sweep", ...
    /// @param option  what the user gave the folder as, for messages
    /// @throws InputError when it cannot be written or made, holds results of another kind, or another
    /// process writes to it
    ResultFolder(std::filesystem::path folder, std::string kind, const std::string& option = "--out ");

    const std::filesystem::path& path() const { return folder_; }
    /// The folder as messages name it: "--out runs/a".
    const std::string& name() const { return name_; }
    /// Whether the program wrote something here before.
    bool is_used() const { return !files_.empty(); }
    bool has_written(const std::string& file) const { return files_.contains(file); }

    /// Names are relative to the folder.
    /// @throws InputError naming the first of the files that is there but was not written by the program
    void require_free(std::span<const std::string> files) const;

    /// Makes and locks the folder unless it was there.
    /// @throws InputError when that fails, or another process has written there since the constructor looked
    void make();

    /// Puts files on the list and makes the folders they go to: to be called before they are written.
    /// @throws InputError as require_free; RunError when the list cannot be written
    void claim(std::span<const std::string> files);

    /// Removes every file on the list, and the leftovers; the list is empty then.
    void remove_written();
    /// Removes what a killed process left half-written of files on the list.
    void remove_leftovers() const;

  private:
    void open();
    void read_list();
    void require_writable() const;

    std::filesystem::path folder_;
    std::string kind_;
    std::string name_;
    std::optional<FolderLock> lock_; ///< from when the folder is there
    std::set<std::string> files_;
};

} // namespace corticle::record

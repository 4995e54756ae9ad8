// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/record/result_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <vector>

namespace corticle::record
{

namespace
{

namespace fs = std::filesystem;

constexpr std::string_view list_start = "# corticle ";
constexpr std::string_view list_rest = ": the files it wrote here; no others are ever replaced or removed";

// Whoever only looks whether a folder is locked holds it for an instant.
constexpr int lock_attempts = 5;
constexpr useconds_t lock_pause_us = 20000;

std::optional<FolderLock> lock_patiently(const fs::path& folder)
{
    std::optional<FolderLock> lock = FolderLock::try_lock(folder);
    for (int attempt = 1; !lock && attempt < lock_attempts; ++attempt)
    {
        usleep(lock_pause_us);
        lock = FolderLock::try_lock(folder);
    }
    return lock;
}

std::string with_article(const std::string& noun)
{
    return (std::string_view("aeiou").find(noun.front()) != std::string_view::npos ? "an " : "a ") + noun;
}

/// Whether a line of a list leads to a place inside the folder.
bool is_inside(const fs::path& file)
{
    return !file.empty() && file.is_relative() && file.has_filename() &&
           std::ranges::none_of(file, [](const fs::path& part) { return part == ".."; });
}

/// The first component of the path of a file that exists and is not a folder; empty where there is none.
fs::path obstacle(const fs::path& folder, const fs::path& file)
{
    fs::path way;
    for (const fs::path& part : file.parent_path())
    {
        way /= part;
        std::error_code error;
        const fs::file_status status = fs::status(folder / way, error);
        if (status.type() != fs::file_type::not_found && !fs::is_directory(status))
        {
            return way;
        }
    }
    return {};
}

void make_folders(const fs::path& folder, const std::string& name)
{
    std::error_code error;
    fs::create_directories(folder, error);
    if (error)
    {
        throw InputError(
            fmt::format("{}: cannot be made: {}; expected a folder that can be written", name, error.message()));
    }
}

} // namespace

ResultFolder::ResultFolder(fs::path folder, std::string kind, const std::string& option)
    : folder_(std::move(folder)), kind_(std::move(kind)), name_(option + folder_.string())
{
    require_writable();
    open();
}

void ResultFolder::require_writable() const
{
    std::error_code error;
    fs::path existing = fs::absolute(folder_, error).lexically_normal();
    fs::file_status status = fs::status(existing, error);
    while (status.type() == fs::file_type::not_found && existing.has_relative_path())
    {
        existing = existing.parent_path();
        status = fs::status(existing, error);
    }
    if (status.type() == fs::file_type::none)
    {
        throw InputError(fmt::format("{}: {}; expected a folder that can be written", name_, error.message()));
    }
    if (!fs::is_directory(status) || access(existing.c_str(), W_OK | X_OK) != 0)
    {
        throw InputError(
            fmt::format("{}: {} is not a folder that can be written; expected one", name_, existing.string()));
    }
}

/// Locks the folder if it is there, and only then looks at what it holds.
void ResultFolder::open()
{
    std::error_code error;
    if (!fs::is_directory(folder_, error))
    {
        return;
    }
    if (!lock_)
    {
        lock_ = lock_patiently(folder_);
    }
    if (!lock_)
    {
        throw InputError(fmt::format("{}: another process is writing there; expected a folder of its own", name_));
    }
    read_list();
}

void ResultFolder::read_list()
{
    files_.clear();
    std::error_code error;
    const fs::path list = folder_ / list_name;
    if (fs::symlink_status(list, error).type() == fs::file_type::not_found)
    {
        return;
    }
    const auto refuse = [&](const std::string& got)
    {
        return InputError(fmt::format("{}: {} {}; expected the list of files that corticle wrote there, or none", name_,
                                      list_name, got));
    };
    std::ifstream stream(list);
    std::string line;
    if (!fs::is_regular_file(list, error) || !std::getline(stream, line) || !line.starts_with(list_start) ||
        !line.ends_with(list_rest))
    {
        throw refuse("is not of corticle");
    }
    const std::string kind = line.substr(list_start.size(), line.size() - list_start.size() - list_rest.size());
    if (kind != kind_)
    {
        throw InputError(
            fmt::format("{}: holds {}; expected another folder for the {}", name_, with_article(kind), kind_));
    }
    while (std::getline(stream, line))
    {
        if (!is_inside(line))
        {
            throw refuse("is damaged");
        }
        files_.insert(line);
    }
}

void ResultFolder::require_free(std::span<const std::string> files) const
{
    for (const std::string& file : files)
    {
        const fs::path blocked = obstacle(folder_, file);
        std::error_code error;
        const fs::file_type type = fs::symlink_status(folder_ / file, error).type();
        const bool is_ours = has_written(file) && type != fs::file_type::directory;
        if (!blocked.empty() || (type != fs::file_type::not_found && !is_ours))
        {
            throw InputError(fmt::format("{}: {} is in the way: {} does not name it as a file that corticle wrote; "
                                         "expected another folder, or that file moved elsewhere",
                                         name_, blocked.empty() ? file : blocked.string(), list_name));
        }
    }
}

void ResultFolder::make()
{
    const bool was_there = lock_.has_value();
    make_folders(folder_, name_);
    open();
    if (!was_there && is_used())
    {
        throw InputError(fmt::format("{}: another process has made it meanwhile; expected a folder of its own", name_));
    }
}

void ResultFolder::claim(std::span<const std::string> files)
{
    require_free(files);
    const std::size_t before = files_.size();
    for (const std::string& file : files)
    {
        make_folders((folder_ / file).parent_path(), name_);
        files_.insert(file);
    }
    if (files_.size() == before)
    {
        return;
    }
    std::string text = fmt::format("{}{}{}\n", list_start, kind_, list_rest);
    for (const std::string& file : files_)
    {
        text += file + "\n";
    }
    formats::write_text_atomically(folder_ / list_name, text);
}

void ResultFolder::remove_leftovers() const
{
    std::set<fs::path> places{folder_};
    for (const std::string& file : files_)
    {
        places.insert((folder_ / file).parent_path());
    }
    for (const fs::path& place : places)
    {
        std::vector<fs::path> leftovers;
        std::error_code error;
        for (const auto& item : fs::directory_iterator(place, error))
        {
            const std::string target = formats::target_of_temporary(item.path().filename().string());
            const std::string file = ((place / target).lexically_relative(folder_)).string();
            if (!target.empty() && (file == list_name || has_written(file)) && item.is_regular_file(error))
            {
                leftovers.push_back(item.path());
            }
        }
        for (const fs::path& leftover : leftovers)
        {
            fs::remove(leftover, error);
        }
    }
}

void ResultFolder::remove_written()
{
    remove_leftovers();
    for (const std::string& file : files_)
    {
        std::error_code error;
        const fs::path path = folder_ / file;
        if (fs::symlink_status(path, error).type() == fs::file_type::directory)
        {
            continue; // somebody put it where the file was
        }
        if (!fs::remove(path, error) && error && error != std::errc::not_a_directory)
        {
            throw RunError(fmt::format("cannot remove {}: {}", path.string(), error.message()));
        }
    }
    files_.clear();
}

} // namespace corticle::record

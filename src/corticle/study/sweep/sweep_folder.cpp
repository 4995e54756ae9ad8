// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/sweep/sweep_folder.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/case_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <set>

namespace corticle::sweep
{

namespace
{

namespace fs = std::filesystem;

/// Identity of the case in a run folder; empty where it cannot be read, which is as good as another case.
std::string identity_in(const fs::path& folder)
{
    try
    {
        return case_identity(config::read_case(folder / "case.toml", {}));
    }
    catch (const InputError&)
    {
        return "";
    }
}

/// Folders in OUT/runs in which a run was begun, by the identity of its case; in the order of their names.
std::multimap<std::string, fs::path> begun_runs(const fs::path& runs)
{
    std::vector<fs::path> folders;
    std::error_code error;
    if (fs::is_directory(runs, error))
    {
        for (const auto& item : fs::directory_iterator(runs))
        {
            if (fs::exists(item.path() / "case.toml", error))
            {
                folders.push_back(item.path());
            }
        }
    }
    std::ranges::sort(folders);
    std::multimap<std::string, fs::path> result;
    for (const fs::path& folder : folders)
    {
        result.emplace(identity_in(folder), folder);
    }
    return result;
}

/// Of the folders with this case the one that is finished, else the first; empty where there is none.
fs::path find_same(const std::multimap<std::string, fs::path>& begun, const std::string& identity)
{
    const auto [first, last] = begun.equal_range(identity);
    const auto finished =
        std::find_if(first, last, [](const auto& entry) { return read_state(entry.second).is_finished(); });
    return finished != last ? finished->second : first != last ? first->second : fs::path();
}

std::vector<std::string> read_warnings(const fs::path& log)
{
    constexpr std::string_view mark = "] [warning] ";
    std::vector<std::string> warnings;
    std::ifstream stream(log);
    for (std::string line; std::getline(stream, line);)
    {
        const std::size_t at = line.find(mark);
        const std::string text = at == std::string::npos ? "" : line.substr(at + mark.size());
        if (!text.empty() && std::ranges::find(warnings, text) == warnings.end())
        {
            warnings.push_back(text);
        }
    }
    return warnings;
}

} // namespace

RunState read_state(const fs::path& run_folder)
{
    RunState state;
    state.warnings = read_warnings(run_folder / "run.log");
    std::ifstream stream(run_folder / "summary.json");
    const auto summary = nlohmann::json::parse(stream, nullptr, false);
    if (!summary.is_object())
    {
        return state;
    }
    for (const auto& [key, value] : summary.items())
    {
        if (value.is_number())
        {
            state.numbers[key] = value.get<double>();
        }
    }
    const auto text = [&](const char* key)
    { return summary.contains(key) && summary[key].is_string() ? summary[key].get<std::string>() : std::string(); };
    const std::string status = text("status");
    if (status == "completed" || status == "failed" || status == "interrupted")
    {
        state.status = status;
        state.reason = text("reason");
        state.version = text("version");
    }
    return state;
}

RunFolders assign_folders(const fs::path& out, std::span<const SweepRun> runs)
{
    const auto begun = begun_runs(out / "runs");
    std::set<fs::path> used;
    std::map<std::string, fs::path> by_identity;
    std::vector<std::string> identities;
    for (const SweepRun& run : runs)
    {
        identities.push_back(case_identity(run.options));
        if (const fs::path same = find_same(begun, identities.back()); !same.empty())
        {
            by_identity[identities.back()] = same;
            used.insert(same);
        }
    }
    RunFolders folders;
    folders.unused = static_cast<std::size_t>(
        std::ranges::count_if(begun, [&](const auto& entry) { return !used.contains(entry.second); }));
    for (const auto& entry : begun)
    {
        used.insert(entry.second); // never overwritten
    }
    for (std::size_t i = 0; i < runs.size(); ++i)
    {
        fs::path& folder = by_identity[identities[i]];
        for (int number = 1; folder.empty(); ++number)
        {
            fs::path free = out / "runs" / (runs[i].name + (number == 1 ? "" : fmt::format("_{}", number)));
            if (used.insert(free).second)
            {
                folder = std::move(free);
            }
        }
        folders.of_run.push_back(folder);
    }
    return folders;
}

} // namespace corticle::sweep

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/sources.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"

#include <fmt/format.h>

namespace corticle::report
{

namespace fs = std::filesystem;

Json read_json(const fs::path& file)
{
    Json json = Json::parse(formats::read_whole_file(file), nullptr, false);
    if (!json.is_object())
    {
        throw InputError(fmt::format("{}: not a JSON object; expected what corticle wrote", file.string()));
    }
    return json;
}

bool is_there(const fs::path& file)
{
    std::error_code error;
    return fs::exists(file, error);
}

fs::path found_from(const fs::path& folder, const std::string& path)
{
    for (const fs::path& place : {fs::path(path), folder / ".." / path, folder / path})
    {
        if (is_there(place))
        {
            return place;
        }
    }
    throw InputError(fmt::format("{}: not found from here, nor from {}; start the command where it was compared", path,
                                 folder.string()));
}

} // namespace corticle::report

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/formats/companion_files.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/format_error.hpp"
#include "corticle/formats/plain_file.hpp"
#include "corticle/formats/sha256.hpp"
#include "corticle/formats/xml_tag.hpp"

#include <algorithm>

namespace corticle::formats
{

namespace
{

std::vector<std::filesystem::path> external_files(const std::filesystem::path& file)
{
    std::vector<std::filesystem::path> names;
    const std::string bytes = read_plain_file(file).bytes;
    XmlTag tag;
    for (std::size_t position = 0; next_tag(bytes, position, tag); position = tag.end)
    {
        const std::filesystem::path name = unescape_xml(tag.attribute("ExternalFileName"));
        if (tag.name == "DataArray" && !name.empty() && std::ranges::find(names, name) == names.end())
        {
            names.push_back(name);
        }
    }
    std::ranges::for_each(names, [&](std::filesystem::path& name) { name = file.parent_path() / name.filename(); });
    return names;
}

} // namespace

std::filesystem::path other_of_pair(const std::filesystem::path& file)
{
    const bool is_header = plain_extension(file) == "hdr";
    if (!is_header && plain_extension(file) != "img")
    {
        return {};
    }
    std::filesystem::path stem = file;
    stem = lower_case_extension(stem) == "gz" ? stem.replace_extension() : stem;
    for (const char* ending : {is_header ? ".img" : ".hdr", is_header ? ".IMG" : ".HDR"})
    {
        for (const char* packed : {"", ".gz", ".GZ"})
        {
            std::filesystem::path other = stem;
            other.replace_extension(ending);
            other += packed;
            std::error_code error;
            if (std::filesystem::exists(other, error))
            {
                return other;
            }
        }
    }
    return {};
}

std::vector<std::filesystem::path> companion_files(const std::filesystem::path& file)
{
    try
    {
        const std::filesystem::path other = other_of_pair(file);
        return !other.empty()                   ? std::vector{other}
               : plain_extension(file) == "gii" ? external_files(file)
                                                : std::vector<std::filesystem::path>{};
    }
    catch (const InputError&)
    {
        return {}; // what is wrong with the file, its reader will say
    }
}

std::string sha256_with_companions(const std::filesystem::path& file)
{
    std::string sums = sha256_of_file(file);
    const std::vector<std::filesystem::path> others = companion_files(file);
    for (const std::filesystem::path& other : others)
    {
        const std::string sum = sha256_of_file(other);
        if (sums.empty() || sum.empty())
        {
            return {};
        }
        sums += sum;
    }
    return others.empty() ? sums : sha256_of_text(sums);
}

} // namespace corticle::formats

// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.hpp"

#include "corticle/base/error.hpp"
#include "corticle/config/starter.hpp"
#include "corticle/formats/volumes/nifti_write.hpp"
#include "corticle/imaging/phantom.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

namespace corticle
{

namespace
{

constexpr std::string_view brain_case = R"(# A phantom of a fetal brain of about 23 weeks, from its tissue labels.
#   corticle prepare brain.toml     look at the body first
#   corticle run brain.toml         fold it

[geometry]
shape = "file"
file = "brain.nii.gz"
labels = [2, 3, 5, 7]     # cortical grey matter, white matter, ventricles, deep grey matter
particles = 60000

[tissue]
layer = "smooth"
thickness_mm = 2.5

[output]
count = 10
)";

/// Writes a text that must not be there yet.
void write_new(const std::string& name, std::string_view text)
{
    std::FILE* file = std::fopen(name.c_str(), "wx"); // x: fails where the file exists
    if (file == nullptr)
    {
        throw InputError(fmt::format("cannot write case {}: {}", name,
                                     errno == EEXIST ? "it exists, and new never overwrites" : std::strerror(errno)));
    }
    const bool written = std::fwrite(text.data(), 1, text.size(), file) == text.size();
    if ((std::fclose(file) != 0) || !written)
    {
        std::remove(name.c_str());
        throw RunError(fmt::format("cannot write case {}: the disk refused it", name));
    }
    fmt::print("wrote {}\n", name);
}

/// The built-in brain: brain.nii.gz, its lobes and brain.toml in the present folder.
void write_brain()
{
    constexpr const char* image = "brain.nii.gz";
    constexpr const char* lobes = "brain_lobes.nii.gz";
    for (const char* name : {image, lobes, "brain.toml"})
    {
        std::error_code error;
        if (std::filesystem::exists(std::filesystem::symlink_status(name, error)))
        {
            throw InputError(fmt::format("cannot write {}: it exists, and new never overwrites", name));
        }
    }
    formats::write_nifti(image, imaging::make_brain_phantom({}));
    fmt::print("wrote {}\n", image);
    formats::write_nifti(lobes, imaging::make_phantom_lobes({}));
    fmt::print("wrote {}: 1 frontal, 2 parietal, 3 temporal, 4 occipital on the left; 11 to 14 on the right\n", lobes);
    write_new("brain.toml", brain_case);
}

} // namespace

int new_command(const NewArguments& arguments)
{
    if (arguments.what == "brain")
    {
        write_brain();
        return exit_status::done;
    }
    const std::filesystem::path file = arguments.what;
    if (file.extension() != ".toml")
    {
        throw InputError(
            fmt::format("cannot write case: got {}, expected brain or a name that ends in .toml", file.string()));
    }
    write_new(file.string(), config::starter_case(arguments.shape));
    return exit_status::done;
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/label_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/nifti.hpp"
#include "corticle/geometry/validate.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace corticle::prepare
{

imaging::ImagedSurface read_label_surface(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                          formats::Coordinates coordinates, std::vector<std::string>& notes)
{
    imaging::LabelVolume image = formats::read_nifti(file, {mask.volume, coordinates});
    std::ranges::move(image.notes, std::back_inserter(notes));
    return label_surface(image, mask, file);
}

imaging::ImagedSurface label_surface(const imaging::LabelVolume& image, const imaging::MaskOptions& mask,
                                     const std::filesystem::path& file)
{
    try
    {
        imaging::ImagedSurface imaged = imaging::surface_from_labels(image, mask);
        geometry::require_valid_surface(imaged.surface, "its surface");
        return imaged;
    }
    catch (const InputError& error)
    {
        throw InputError(fmt::format("{}: {}", file.string(), error.what()));
    }
}

} // namespace corticle::prepare

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/prepare/label_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/formats/volumes/volume_reader.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/orientation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace corticle::prepare
{

imaging::LabelVolume read_body_labels(const GeometryOptions& geometry)
{
    return formats::read_labels(geometry.file, {geometry.mask.volume, geometry.coordinates, geometry.mask.threshold});
}

imaging::LabelVolume read_label_image(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                      formats::Coordinates coordinates, std::vector<std::string>& notes)
{
    imaging::LabelVolume image = formats::read_labels(file, {mask.volume, coordinates, mask.threshold});
    notes.push_back(imaging::describe(image));
    if (mask.threshold)
    {
        notes.push_back(fmt::format("a map of probabilities: the body is where it is at least {:g}", *mask.threshold));
    }
    std::ranges::move(image.notes, std::back_inserter(notes));
    return image;
}

imaging::ImagedSurface read_label_surface(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                          formats::Coordinates coordinates, std::vector<std::string>& notes)
{
    return label_surface(read_label_image(file, mask, coordinates, notes), mask, file);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/imaging/surface_from_labels.hpp"
#include "corticle/prepare/options.hpp"

#include <filesystem>

namespace corticle::prepare
{

/// The labels that the options name; those of a map of probabilities are 1 and 0. @throws InputError
imaging::LabelVolume read_body_labels(const GeometryOptions& geometry);
/// The same; `notes` receives size and orientation of the image, and a line for each field of the header that was not
/// taken as it stands.
imaging::LabelVolume read_label_image(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                      formats::Coordinates coordinates, std::vector<std::string>& notes);

/// The surface of the labels of an image, for whatever reads one: prepare, run, measure and compare. `notes` as
/// for read_label_image.
/// @throws InputError, one line naming the file
imaging::ImagedSurface read_label_surface(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                          formats::Coordinates coordinates, std::vector<std::string>& notes);

/// The surface of labels that were read. @throws InputError, one line naming the file
imaging::ImagedSurface label_surface(const imaging::LabelVolume& image, const imaging::MaskOptions& mask,
                                     const std::filesystem::path& file);

} // namespace corticle::prepare

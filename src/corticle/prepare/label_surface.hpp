// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/formats/coordinates.hpp"
#include "corticle/imaging/surface_from_labels.hpp"

#include <filesystem>

namespace corticle::prepare
{

/// The surface of the labels of a NIfTI file, for whatever reads one: prepare, run, measure and compare. `notes`
/// receives a line for each field of the header that was not taken as it stands.
/// @throws InputError, one line naming the file
imaging::ImagedSurface read_label_surface(const std::filesystem::path& file, const imaging::MaskOptions& mask,
                                          formats::Coordinates coordinates, std::vector<std::string>& notes);

/// The surface of labels that were read. @throws InputError, one line naming the file
imaging::ImagedSurface label_surface(const imaging::LabelVolume& image, const imaging::MaskOptions& mask,
                                     const std::filesystem::path& file);

} // namespace corticle::prepare

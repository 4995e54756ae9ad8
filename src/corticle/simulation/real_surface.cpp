// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/simulation/real_surface.hpp"

#include "corticle/base/error.hpp"
#include "corticle/geometry/validate.hpp"
#include "corticle/imaging/surface_from_labels.hpp"
#include "corticle/io/nifti.hpp"
#include "corticle/io/surface_reader.hpp"

#include <fmt/format.h>

namespace corticle
{

MaskOptions measuring_mask()
{
    MaskOptions mask;
    mask.closing_mm = 0.0;
    mask.smoothing_mm = 0.7;
    return mask;
}

TriangleMesh read_real_surface(const std::filesystem::path& file, const RealSurfaceOptions& options)
{
    TriangleMesh surface;
    if (is_nifti(file))
    {
        surface = surface_from_labels(read_nifti(file, options.mask.volume), options.mask).surface;
    }
    else if (!options.mask.labels.empty())
    {
        throw InputError(fmt::format("{}: --labels is given, but this is no label volume; expected a NIfTI file, or no "
                                     "--labels",
                                     file.string()));
    }
    else
    {
        surface = read_surface(file, millimetres_per(options.unit));
    }
    require_valid_surface(surface, file.string());
    return surface;
}

} // namespace corticle

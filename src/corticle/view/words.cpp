// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/words.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace corticle::view
{

namespace
{

constexpr std::array labels{
    std::pair{"t", "growth time"},
    std::pair{"week", "gestational week"},
    std::pair{"length_scale", "length scale"},
    std::pair{"area_ratio", "area over initial area"},
    std::pair{"volume_ratio", "volume over initial volume"},
    std::pair{"curved_area_ratio", "curved area over initial"},
    std::pair{"curved_volume_ratio", "curved volume over initial"},
    std::pair{"thickness_mean_mm", "cortical thickness, mean"},
    std::pair{"fold_wavelength_reference_mm", "fold wavelength, reference surface"},
    std::pair{"fold_degree", "spherical harmonic of the folds"},
    std::pair{"J", "volume ratio J"},
    std::pair{"J_min", "volume ratio J, least"},
    std::pair{"J_mean", "volume ratio J, mean"},
    std::pair{"J_max", "volume ratio J, largest"},
    std::pair{"growth", "growth g"},
    std::pair{"theta", "share of cortex θ"},
    std::pair{"thickness", "cortical thickness"},
    std::pair{"sulcal_depth", "sulcal depth"},
    std::pair{"mean_curvature", "mean curvature"},
    std::pair{"local_gyrification", "local gyrification index"},
    std::pair{"von_mises", "stress (von Mises)"},
    std::pair{"distance", "distance to the other surface"},
    std::pair{"gi_hull", "gyrification index, over hull"},
    std::pair{"gi_sphere", "gyrification index, over sphere"},
    std::pair{"gi_zilles", "gyrification index, coronal slices"},
    std::pair{"gi_local_mean", "local gyrification index, mean"},
    std::pair{"curved_gi_hull", "curved gyrification index, over hull"},
    std::pair{"curved_gi_sphere", "curved gyrification index, over sphere"},
    std::pair{"sulcal_depth_mean_mm", "sulcal depth, mean"},
    std::pair{"sulcal_depth_max_mm", "sulcal depth, largest"},
    std::pair{"abs_mean_curvature_per_mm", "absolute mean curvature, mean"},
    std::pair{"curvedness_per_mm", "curvedness, mean"},
    std::pair{"fold_wavelength_mm", "fold wavelength"},
    std::pair{"onset_t", "onset of folding, growth time"},
    std::pair{"asymmetry_area", "asymmetry of area, left less right"},
    std::pair{"asymmetry_volume", "asymmetry of volume, left less right"},
    std::pair{"energy_zero_mode", "energy, zero-energy control"},
    std::pair{"energy_contact_limit", "energy taken by the travel limit"},
    std::pair{"work_growth", "work of growth"},
    std::pair{"area_mm2", "area"},
    std::pair{"volume_mm3", "volume"},
    std::pair{"hull_area_mm2", "area of the convex hull"},
    std::pair{"wall_s", "wall time"},
};

// From a table of its own so that pages, pictures and the command line tell the same of an array.
constexpr std::array scalars{
    Scalar{"sulcal_depth", "mm", "depth below the outer surface", ColorMap::viridis_reversed},
    Scalar{"mean_curvature", "1/mm", "above 0 on gyri, below 0 in sulci", ColorMap::blue_orange},
    Scalar{"thickness", "mm", "distance between the surface and the boundary to the white matter", ColorMap::viridis},
    Scalar{"J", "", "volume over initial volume, det F", ColorMap::viridis},
    Scalar{"growth", "", "growth in the plane of the cortex", ColorMap::viridis},
    Scalar{"von_mises", "mu_w", "von Mises stress, over the shear modulus of the white matter", ColorMap::viridis},
    Scalar{"local_gyrification", "", "area of the surface nearby over that of the outer surface", ColorMap::viridis},
    Scalar{"theta", "", "1 cortex, 0 white matter", ColorMap::viridis},
    Scalar{"region", "", "label of the region", ColorMap::regions},
    Scalar{"distance", "mm", "from each vertex to the closest point of the other surface", ColorMap::viridis},
};

} // namespace

std::string label_of(std::string_view key)
{
    const auto known = std::ranges::find(labels, key, [](const auto& pair) { return std::string_view(pair.first); });
    if (known != labels.end())
    {
        return known->second;
    }
    for (const std::string_view unit : {"_per_mm", "_mm3", "_mm2", "_mm", "_s", "_mb"})
    {
        key = key.ends_with(unit) ? key.substr(0, key.size() - unit.size()) : key;
    }
    std::string words(key);
    std::ranges::replace(words, '_', ' ');
    return words;
}

std::string unit_text(std::string_view unit)
{
    std::string text;
    for (std::size_t i = 0; i < unit.size(); ++i)
    {
        const bool is_power = i > 0 && unit[i - 1] == 'm';
        text += is_power && unit[i] == '2' ? "²" : is_power && unit[i] == '3' ? "³" : std::string(1, unit[i]);
    }
    if (const std::size_t mu = text.find("mu_w"); mu != std::string::npos)
    {
        text.replace(mu, 4, "μ_w");
    }
    return text == "-" ? "" : text;
}

std::span<const Scalar> known_scalars()
{
    return scalars;
}

Scalar scalar_of(std::string_view key)
{
    const auto known = std::ranges::find(scalars, key, &Scalar::key);
    return known != scalars.end() ? *known : Scalar{key, {}, {}, ColorMap::viridis};
}

std::string titled(std::string_view key, std::string_view unit)
{
    const std::string shown = unit_text(unit);
    return label_of(key) + (shown.empty() ? "" : " [" + shown + "]");
}

} // namespace corticle::view

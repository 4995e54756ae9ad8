// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/view/color_map.hpp"

#include <algorithm>
#include <cmath>
#include <span>

namespace corticle::view
{

namespace
{

// Equidistant samples, 0 to 255. Viridis: S. van der Walt and N. Smith (2015). Cividis: J. Nuñez, C. Anderton and
// R. Renslow (2018). Coolwarm: K. Moreland (2009).
constexpr std::array<Color, 9> viridis{{{68, 1, 84},
                                        {71, 45, 123},
                                        {59, 82, 139},
                                        {44, 114, 142},
                                        {33, 144, 141},
                                        {39, 173, 129},
                                        {93, 200, 99},
                                        {170, 220, 50},
                                        {253, 231, 37}}};
constexpr std::array<Color, 9> coolwarm{{{59, 76, 192},
                                         {98, 130, 234},
                                         {141, 176, 254},
                                         {184, 208, 249},
                                         {221, 221, 221},
                                         {245, 196, 173},
                                         {244, 154, 123},
                                         {222, 96, 77},
                                         {180, 4, 38}}};
constexpr std::array<Color, 5> cividis{{{0, 34, 78}, {65, 77, 107}, {124, 123, 120}, {188, 175, 111}, {254, 232, 56}}};
constexpr std::array<Color, 5> blue_orange{
    {{20, 54, 120}, {96, 148, 204}, {236, 236, 232}, {226, 148, 72}, {128, 56, 8}}};
constexpr std::array<Color, 2> greys{{{40, 40, 40}, {235, 235, 235}}};
constexpr std::array<Color, 2> tissue{{{208, 218, 228}, {196, 78, 62}}};
/// Labels of regions, for whole numbers in turn. M. Okabe and K. Ito (2008).
constexpr std::array<Color, 8> regions{{{160, 160, 160},
                                        {230, 159, 0},
                                        {86, 180, 233},
                                        {0, 158, 115},
                                        {240, 228, 66},
                                        {0, 114, 178},
                                        {213, 94, 0},
                                        {204, 121, 167}}};
constexpr Color missing{0.5, 0.5, 0.5};

std::span<const Color> samples_of(ColorMap map)
{
    switch (map)
    {
    case ColorMap::cividis:
        return cividis;
    case ColorMap::coolwarm:
        return coolwarm;
    case ColorMap::blue_orange:
        return blue_orange;
    case ColorMap::grey:
        return greys;
    case ColorMap::tissue:
        return tissue;
    case ColorMap::regions:
        return regions;
    case ColorMap::viridis:
    case ColorMap::viridis_reversed:
        break;
    }
    return viridis;
}

} // namespace

Color map_color(ColorMap map, double fraction)
{
    if (std::isnan(fraction))
    {
        return missing;
    }
    const std::span<const Color> samples = samples_of(map);
    const double share = std::clamp(fraction, 0.0, 1.0);
    const double position =
        (map == ColorMap::viridis_reversed ? 1.0 - share : share) * static_cast<double>(samples.size() - 1);
    const std::size_t left = std::min(static_cast<std::size_t>(position), samples.size() - 2);
    const double weight = position - static_cast<double>(left);
    Color color{};
    for (std::size_t i = 0; i < 3; ++i)
    {
        color[i] = ((1.0 - weight) * samples[left][i] + weight * samples[left + 1][i]) / 255.0;
    }
    return color;
}

const char* name_of(ColorMap map)
{
    return color_map_names[static_cast<std::size_t>(map)];
}

Color region_color(std::int64_t label)
{
    constexpr auto count = static_cast<std::int64_t>(regions.size());
    const Color& color = regions[static_cast<std::size_t>((label % count + count) % count)];
    return {color[0] / 255.0, color[1] / 255.0, color[2] / 255.0};
}

} // namespace corticle::view

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/box_tiles.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace corticle::contact
{

namespace
{

constexpr float largest = std::numeric_limits<float>::max(); ///< below the corners of an empty place

/// A float not above a number; what lies beyond 1e38 counts as lying there.
float rounded_down(double a)
{
    const auto near = static_cast<float>(std::clamp(a, -1e38, 1e38));
    return near - std::abs(near) * std::numeric_limits<float>::epsilon() - std::numeric_limits<float>::min();
}

} // namespace

/// Tests of one box against a tile, and the way down to what it overlaps.
struct TileSearch
{
    using Tile = BoxTiles::Tile;
    static constexpr std::int32_t width = BoxTiles::width;
    using Floats = float __attribute__((vector_size(16), may_alias));
    using Flags = std::int32_t __attribute__((vector_size(16)));

    struct Corners
    {
        std::array<float, 3> low;
        std::array<float, 3> high;
    };

    CORTICLE_INLINE static Corners at(const Tile& tile, std::int32_t k)
    {
        return {{tile.low[0][k], tile.low[1][k], tile.low[2][k]}, {tile.high[0][k], tile.high[1][k], tile.high[2][k]}};
    }

    static Box box_of(const Corners& corners)
    {
        return {{corners.low[0], corners.low[1], corners.low[2]}, {corners.high[0], corners.high[1], corners.high[2]}};
    }

    /// The box around those of a tile.
    static Corners around(const Tile& tile)
    {
        Corners box{};
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
            box.low[axis] = *std::ranges::min_element(tile.low[axis]);
            box.high[axis] = *std::ranges::max_element(tile.high[axis]);
        }
        return box;
    }

    /// The places of a tile whose boxes overlap, as bits.
    CORTICLE_INLINE static std::uint32_t overlapping(const Tile& tile, const Corners& box)
    {
        Flags bits{};
        Flags bit{1, 2, 4, 8};
        for (std::size_t k = 0; k < width; k += 4)
        {
            const auto four = [&](const std::array<float, width>& row) -> const Floats&
            { return *reinterpret_cast<const Floats*>(row.data() + k); };
            bits |= bit & (four(tile.low[0]) <= box.high[0]) & (four(tile.high[0]) >= box.low[0]) &
                    (four(tile.low[1]) <= box.high[1]) & (four(tile.high[1]) >= box.low[1]) &
                    (four(tile.low[2]) <= box.high[2]) & (four(tile.high[2]) >= box.low[2]);
            bit <<= 4;
        }
        return static_cast<std::uint32_t>(bits[0] | bits[1] | bits[2] | bits[3]);
    }

    /// Calls act(k) for every place k, in ascending order.
    template <class Act>
    CORTICLE_INLINE static void for_places(std::uint32_t places, Act&& act)
    {
        for (; places != 0; places &= places - 1)
        {
            act(std::countr_zero(places));
        }
    }
};

void BoxTiles::Tile::put(std::int64_t k, const Box& box)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        low[axis][k] = rounded_down(box.low[axis]);
        high[axis][k] = -rounded_down(-box.high[axis]);
    }
}

/// Makes room for a level of that many boxes.
std::vector<BoxTiles::Tile>& BoxTiles::level(std::size_t number, std::int64_t count)
{
    levels_.resize(std::max(levels_.size(), number + 1));
    levels_[number].resize(static_cast<std::size_t>(std::max<std::int64_t>(1, (count + width - 1) / width)));
    return levels_[number];
}

/// Boxes around the tiles of each level, up to a single tile.
void BoxTiles::enclose()
{
    std::size_t number = 0;
    for (; levels_[number].size() > 1; ++number)
    {
        level(number + 1, std::ssize(levels_[number]));
        const std::vector<Tile>& below = levels_[number];
        std::vector<Tile>& above = levels_[number + 1];
        parallel_blocks(
            std::ssize(above),
            [&](std::int64_t begin, std::int64_t end)
            {
                for (std::int64_t tile = begin; tile < end; ++tile)
                {
                    above[tile] = {};
                    for (std::int64_t k = tile * width; k < std::min(std::ssize(below), (tile + 1) * width); ++k)
                    {
                        const TileSearch::Corners box = TileSearch::around(below[k]);
                        for (std::size_t axis = 0; axis < 3; ++axis)
                        {
                            above[tile].low[axis][k % width] = box.low[axis];
                            above[tile].high[axis][k % width] = box.high[axis];
                        }
                    }
                }
            },
            tiles_at_a_time);
    }
    levels_.resize(number + 1);
}

Box BoxTiles::box(std::int64_t k) const
{
    const Tile& tile = levels_[0][static_cast<std::size_t>(k / width)];
    return TileSearch::box_of(TileSearch::at(tile, static_cast<std::int32_t>(k % width)));
}

Box BoxTiles::box_around(std::int32_t tile) const
{
    return TileSearch::box_of(TileSearch::around(levels_[0][static_cast<std::size_t>(tile)]));
}

void BoxTiles::keep(const std::vector<std::uint8_t>& is_wanted)
{
    for (std::size_t tile = 0; tile < is_wanted.size(); ++tile)
    {
        if (is_wanted[tile] == 0)
        {
            levels_[0][tile] = {};
        }
    }
    enclose();
}

void BoxTiles::find_overlaps(std::int32_t tile, const BoxTiles& others, std::vector<BoxPair>& found) const
{
    found.clear();
    const bool same = this == &others;
    const Tile& own = levels_[0][static_cast<std::size_t>(tile)];
    const TileSearch::Corners around = TileSearch::around(own);
    // Down from the top; the tiles still to be looked into wait on a stack, the next one last.
    struct Place
    {
        std::int32_t level;
        std::int32_t tile;
        TileSearch::Corners box; ///< around it
    };
    std::array<Place, 8 * width> stack;
    std::size_t waiting = 0;
    stack[waiting++] = {static_cast<std::int32_t>(others.levels_.size()) - 1,
                        0,
                        {{-largest, -largest, -largest}, {largest, largest, largest}}};
    while (waiting > 0)
    {
        const Place next = stack[--waiting];
        const Tile& other = others.levels_[static_cast<std::size_t>(next.level)][static_cast<std::size_t>(next.tile)];
        if (next.level > 0)
        {
            std::uint32_t below = TileSearch::overlapping(other, around);
            while (below != 0)
            {
                const auto k = static_cast<std::int32_t>(std::bit_width(below)) - 1;
                below ^= 1U << k;
                const std::int32_t one = next.tile * width + k;
                // Of the same boxes those before this tile have been its partners already.
                const std::int32_t last = ((one + 1) << (4 * (next.level - 1))) - 1;
                if (!same || last >= tile)
                {
                    stack[waiting++] = {next.level - 1, one, TileSearch::at(other, k)};
                }
            }
            continue;
        }
        std::array<BoxPair, static_cast<std::size_t>(width * width)> here;
        std::size_t count = 0;
        TileSearch::for_places(
            TileSearch::overlapping(own, next.box),
            [&](std::int32_t k)
            {
                const std::int32_t first = tile * width + k;
                std::uint32_t places = TileSearch::overlapping(other, TileSearch::at(own, k));
                if (same && next.tile == tile)
                {
                    places &= ~1U << k; // those after the first
                }
                TileSearch::for_places(places, [&](std::int32_t m) { here[count++] = {first, next.tile * width + m}; });
            });
        found.insert(found.end(), here.begin(), here.begin() + static_cast<std::ptrdiff_t>(count));
    }
}

} // namespace corticle::contact

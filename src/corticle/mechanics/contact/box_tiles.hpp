// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/box.hpp"
#include "corticle/base/parallel.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace corticle::contact
{

/// Two boxes that overlap.
struct BoxPair
{
    std::int32_t first;
    std::int32_t second;
};

/// Boxes in tiles of sixteen consecutive ones, a box around each tile, these in tiles of sixteen again, and so on up to
/// one: boxes that follow each other should lie beside each other. A box is tested against all of a tile at once.
class BoxTiles
{
  public:
    static constexpr std::int32_t width = 16;

    /// @param box_of  box_of(k), for 0 <= k < count; called concurrently
    template <class BoxOf>
    void set(std::int64_t count, BoxOf&& box_of)
    {
        std::vector<Tile>& tiles = level(0, count);
        parallel_blocks(
            std::ssize(tiles),
            [&](std::int64_t begin, std::int64_t end)
            {
                for (std::int64_t tile = begin; tile < end; ++tile)
                {
                    tiles[tile] = {};
                    for (std::int64_t k = tile * width; k < std::min(count, (tile + 1) * width); ++k)
                    {
                        tiles[tile].put(k % width, box_of(k));
                    }
                }
            },
            tiles_at_a_time);
        enclose();
    }

    /// Of the boxes themselves.
    std::int32_t tile_count() const { return static_cast<std::int32_t>(levels_.front().size()); }

    /// A box as it is searched for, and the box around those of a tile; empty where nothing is.
    Box box(std::int64_t k) const;
    Box box_around(std::int32_t tile) const;
    /// Empties the tiles that are not wanted: their boxes overlap nothing. The others are found in the same order.
    void keep(const std::vector<std::uint8_t>& is_wanted);

    /// Sets `found` to every pair of a box of one tile and a box of `others` that overlap, also to some that miss each
    /// other by the rounding of a float; where `others` are the same boxes, to those whose second comes after the
    /// first. The order is that of the second's tile, the first, the second, whatever else is found.
    void find_overlaps(std::int32_t tile, const BoxTiles& others, std::vector<BoxPair>& found) const;

  private:
    static constexpr float nowhere = std::numeric_limits<float>::infinity();
    static constexpr std::int64_t tiles_at_a_time = 8;

    using Row = std::array<float, width>;
    static constexpr Row filled(float value)
    {
        Row row{};
        row.fill(value);
        return row;
    }
    /// Lower and upper corners of sixteen boxes, as floats not inside them; empty places overlap nothing.
    struct Tile
    {
        alignas(64) std::array<Row, 3> low{filled(nowhere), filled(nowhere), filled(nowhere)};
        std::array<Row, 3> high{filled(-nowhere), filled(-nowhere), filled(-nowhere)};

        void put(std::int64_t k, const Box& box);
    };
    std::vector<Tile>& level(std::size_t number, std::int64_t count);
    void enclose();
    friend struct TileSearch;

    /// Tiles of the boxes, of the boxes around those, ...; the last level is one tile.
    std::vector<std::vector<Tile>> levels_;
};

} // namespace corticle::contact

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/mechanics/contact/box_tiles.hpp"

#include "corticle/base/random.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace corticle
{
namespace
{

using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

bool overlap(const Box& a, const Box& b)
{
    for (int axis = 0; axis < 3; ++axis)
    {
        if (a.low[axis] > b.high[axis] || b.low[axis] > a.high[axis])
        {
            return false;
        }
    }
    return true;
}

std::vector<Box> boxes_at_random(std::size_t count, std::uint64_t seed)
{
    std::uint64_t drawn = 0;
    const auto random = [&] { return hash_uniform(seed, drawn++); };
    std::vector<Box> boxes;
    for (std::size_t k = 0; k < count; ++k)
    {
        const double along = 20.0 * static_cast<double>(k) / static_cast<double>(count);
        const Vec3 low{along + random(), random(), random()};
        boxes.push_back({low, low + Vec3{random(), 0.3 * random(), 0.5 * random()}});
    }
    boxes[count / 2].high.x += 30.0; // a long one
    return boxes;
}

Pairs found_by(const contact::BoxTiles& first, const contact::BoxTiles& second)
{
    Pairs pairs;
    std::vector<contact::BoxPair> found;
    for (std::int32_t tile = 0; tile < first.tile_count(); ++tile)
    {
        first.find_overlaps(tile, second, found);
        for (const contact::BoxPair& pair : found)
        {
            pairs.emplace_back(pair.first, pair.second);
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

contact::BoxTiles tiles_of(const std::vector<Box>& boxes)
{
    contact::BoxTiles tiles;
    tiles.set(std::ssize(boxes), [&](std::int64_t k) { return boxes[static_cast<std::size_t>(k)]; });
    return tiles;
}

TEST(BoxTiles, FindWhatABruteForceSearchFinds)
{
    for (const std::size_t count : {1u, 15u, 16u, 17u, 300u, 4200u}) // one level of tiles, two, three, four
    {
        const std::vector<Box> a = boxes_at_random(count, 1);
        const std::vector<Box> b = boxes_at_random(count + 3, 2);
        Pairs with_others;
        Pairs with_themselves;
        for (std::size_t i = 0; i < a.size(); ++i)
        {
            for (std::size_t k = 0; k < b.size(); ++k)
            {
                if (overlap(a[i], b[k]))
                {
                    with_others.emplace_back(i, k);
                }
            }
            for (std::size_t k = i + 1; k < a.size(); ++k)
            {
                if (overlap(a[i], a[k]))
                {
                    with_themselves.emplace_back(i, k);
                }
            }
        }
        const contact::BoxTiles tiles = tiles_of(a);
        EXPECT_EQ(found_by(tiles, tiles_of(b)), with_others) << count;
        EXPECT_EQ(found_by(tiles, tiles), with_themselves) << count;
    }
}

TEST(BoxTiles, ForgetWhatTheyHeldBefore)
{
    contact::BoxTiles tiles = tiles_of(boxes_at_random(5000, 1));
    const std::vector<Box> few = boxes_at_random(20, 3);
    tiles.set(std::ssize(few), [&](std::int64_t k) { return few[static_cast<std::size_t>(k)]; });
    const contact::BoxTiles fresh = tiles_of(few);
    EXPECT_EQ(found_by(tiles, tiles), found_by(fresh, fresh));
    EXPECT_EQ(tiles.tile_count(), 2);
}

TEST(BoxTiles, TouchingBoxesOverlapWhateverTheRoundingOfAFloat)
{
    const std::vector<Box> boxes{{{0.1, 0, 0}, {1.0 / 3.0, 1, 1}}, {{1.0 / 3.0, 0, 0}, {0.7, 1, 1}}};
    const contact::BoxTiles tiles = tiles_of(boxes);
    EXPECT_EQ(found_by(tiles, tiles), (Pairs{{0, 1}}));
}

} // namespace
} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mechanics/tlsph/enriched_gradient.hpp"
#include "corticle/mechanics/tlsph/pair_law.hpp"
#include "corticle/mesh/halo.hpp"

// What goes from rank to rank for a particle: its position, 24 bytes, and its force record without it, 80 bytes, or 224
// where its gradient is enriched.

namespace corticle::tlsph
{

/// The halo of the particles of a share: they read their neighbours, and are read by them.
inline std::vector<HaloPart> halo_of(const PairBlocks& pairs, const Share& share)
{
    if (!share.is_part())
    {
        return {};
    }
    return find_halo(share.partition(), share.ranks().rank(),
                     [&](std::int64_t i, auto&& act)
                     {
                         for (std::int64_t k = pairs.begin[i]; k < pairs.begin[i + 1]; ++k)
                         {
                             act(pairs.neighbor(i, k));
                         }
                     });
}

inline constexpr std::size_t position_numbers = 3;

/// Numbers of a force record, with the products of the particle where there are any.
inline std::size_t record_numbers(const EnrichedGradients& enriched, std::int64_t i)
{
    constexpr std::size_t plain = 10;
    constexpr std::size_t products = 18;
    return enriched.reach[i] == EnrichedGradients::Reach::itself ? plain + products : plain;
}

inline double* put(const Vec3& v, double* at)
{
    *at++ = v.x;
    *at++ = v.y;
    *at++ = v.z;
    return at;
}
inline const double* take(const double* at, Vec3& v)
{
    v.x = *at++;
    v.y = *at++;
    v.z = *at++;
    return at;
}

/// @param products  null where there are none
inline double* put_record(const ForceRecord& record, const ProductTerms* products, double* at)
{
    for (const Vec3& column : record.M.column)
    {
        at = put(column, at);
    }
    *at++ = record.x.lane;
    if (products != nullptr)
    {
        at = put(lanes_of(record.M), at);
        for (const Vec3& column : products->column)
        {
            at = put(column, at);
        }
        at = put({products->column[0].lane, products->column[1].lane, products->column[2].lane}, at);
    }
    return at;
}
/// @param x  position of the particle
inline const double* take_record(const double* at, const Vec3& x, ForceRecord& record, ProductTerms* products)
{
    for (Vec3& column : record.M.column)
    {
        column.lane = 0.0;
        at = take(at, column);
    }
    record.x = x;
    record.x.lane = *at++;
    if (products != nullptr)
    {
        Vec3 lanes;
        at = take(at, lanes);
        set_lanes(lanes, record.M);
        for (Vec3& column : products->column)
        {
            at = take(at, column);
        }
        at = take(at, lanes);
        products->column[0].lane = lanes.x;
        products->column[1].lane = lanes.y;
        products->column[2].lane = lanes.z;
    }
    return at;
}

} // namespace corticle::tlsph

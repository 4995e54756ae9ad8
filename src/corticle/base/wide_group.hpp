// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/mat3.hpp"
#include "corticle/base/simd.hpp"

#include <algorithm>

namespace corticle
{

using WideVec3 = BasicVec3<WideLanes>;
using WideMat3 = BasicMat3<WideLanes>;

/// (a, b) in one register, with their fourth lanes.
CORTICLE_INLINE WideLanes joined(const Lanes& a, const Lanes& b)
{
    return __builtin_shufflevector(a, b, 0, 1, 2, 3, 4, 5, 6, 7);
}

/// Up to eight consecutive points, or pairs of them, that are treated at once, one per lane. Lanes past the last one
/// repeat it and count for nothing.
struct WideGroup
{
    std::int64_t first;
    std::int64_t count; ///< 1 to 8

    CORTICLE_INLINE std::int64_t at(int lane) const { return first + std::min<std::int64_t>(lane, count - 1); }

    /// One number of every point.
    CORTICLE_INLINE WideLanes gather(const double* values) const
    {
        using Unaligned = double __attribute__((vector_size(64), aligned(8), may_alias));
        if (count == wide_lanes)
        {
            return *reinterpret_cast<const Unaligned*>(values + first);
        }
        alignas(64) double lanes[wide_lanes];
        for (int lane = 0; lane < wide_lanes; ++lane)
        {
            lanes[lane] = values[at(lane)];
        }
        return *reinterpret_cast<const WideMemory*>(lanes);
    }

    /// One vector of every point, with its fourth lane: the transpose of eight rows.
    /// @param row  row(i) is a reference to the vector of point i as Lanes
    template <class Row>
    CORTICLE_INLINE WideVec3 gather_rows(Row&& row) const
    {
        const WideLanes r04 = joined(row(at(0)), row(at(4)));
        const WideLanes r15 = joined(row(at(1)), row(at(5)));
        const WideLanes r26 = joined(row(at(2)), row(at(6)));
        const WideLanes r37 = joined(row(at(3)), row(at(7)));
        const WideLanes xz0 = __builtin_shufflevector(r04, r15, 0, 8, 2, 10, 4, 12, 6, 14);
        const WideLanes xz2 = __builtin_shufflevector(r26, r37, 0, 8, 2, 10, 4, 12, 6, 14);
        const WideLanes yw0 = __builtin_shufflevector(r04, r15, 1, 9, 3, 11, 5, 13, 7, 15);
        const WideLanes yw2 = __builtin_shufflevector(r26, r37, 1, 9, 3, 11, 5, 13, 7, 15);
        return {__builtin_shufflevector(xz0, xz2, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(yw0, yw2, 0, 1, 8, 9, 4, 5, 12, 13),
                __builtin_shufflevector(xz0, xz2, 2, 3, 10, 11, 6, 7, 14, 15),
                __builtin_shufflevector(yw0, yw2, 2, 3, 10, 11, 6, 7, 14, 15)};
    }
    /// @param vector  vector(i) is a reference to the vector of point i
    template <class Vector>
    CORTICLE_INLINE WideVec3 gather_vectors(Vector&& vector) const
    {
        return gather_rows([&](std::int64_t i) -> const Lanes& { return lanes(vector(i)); });
    }
    /// One matrix of every point. @param matrix  matrix(i) is a reference to that of point i
    template <class Matrix>
    CORTICLE_INLINE WideMat3 gather_matrices(Matrix&& matrix) const
    {
        const auto column = [&](int c)
        {
            return gather_vectors([&](std::int64_t i) -> const Vec3& { return matrix(i).column[c]; });
        };
        return {{column(0), column(1), column(2)}};
    }

    /// Calls put(lane, row) with the vector of every point that counts, with its fourth lane, as Lanes.
    template <class Put>
    CORTICLE_INLINE void scatter_rows(const WideVec3& v, Put&& put) const
    {
        const WideLanes xy0 = __builtin_shufflevector(v.x, v.y, 0, 8, 2, 10, 4, 12, 6, 14);
        const WideLanes xy1 = __builtin_shufflevector(v.x, v.y, 1, 9, 3, 11, 5, 13, 7, 15);
        const WideLanes zw0 = __builtin_shufflevector(v.z, v.lane, 0, 8, 2, 10, 4, 12, 6, 14);
        const WideLanes zw1 = __builtin_shufflevector(v.z, v.lane, 1, 9, 3, 11, 5, 13, 7, 15);
        alignas(64) Lanes rows[wide_lanes]; // in the order 0, 2, 4, 6, 1, 3, 5, 7
        auto* to = reinterpret_cast<WideMemory*>(rows);
        to[0] = __builtin_shufflevector(xy0, zw0, 0, 1, 8, 9, 2, 3, 10, 11);
        to[1] = __builtin_shufflevector(xy0, zw0, 4, 5, 12, 13, 6, 7, 14, 15);
        to[2] = __builtin_shufflevector(xy1, zw1, 0, 1, 8, 9, 2, 3, 10, 11);
        to[3] = __builtin_shufflevector(xy1, zw1, 4, 5, 12, 13, 6, 7, 14, 15);
        for (int lane = 0; lane < count; ++lane)
        {
            put(lane, rows[(lane % 2) * 4 + lane / 2]);
        }
    }
    /// Writes the vectors of the points that count, with their fourth lanes. @param vector  vector(i), where to
    template <class Vector>
    CORTICLE_INLINE void scatter_vectors(const WideVec3& v, Vector&& vector) const
    {
        scatter_rows(v, [&](int lane, const Lanes& row) { lanes(vector(first + lane)) = row; });
    }

    /// The values of the points that count; 0 in the other lanes, whatever stands there.
    CORTICLE_INLINE WideLanes counted(const WideLanes& values) const
    {
        const WideLanes lane{0, 1, 2, 3, 4, 5, 6, 7};
        return lane < static_cast<double>(count) ? values : WideLanes{};
    }
};

/// The same vector in all lanes.
CORTICLE_INLINE WideVec3 broadcast(const Vec3& v)
{
    return {broadcast<WideLanes>(v.x), broadcast<WideLanes>(v.y), broadcast<WideLanes>(v.z)};
}

/// Sum of the lanes, in order.
CORTICLE_INLINE double sum_of_lanes(WideLanes& a)
{
    double sum = 0.0;
    for (int lane = 0; lane < wide_lanes; ++lane)
    {
        sum += at_lane(a, lane);
    }
    return sum;
}
CORTICLE_INLINE double largest_of_lanes(WideLanes& a)
{
    double largest = at_lane(a, 0);
    for (int lane = 1; lane < wide_lanes; ++lane)
    {
        largest = std::max(largest, at_lane(a, lane));
    }
    return largest;
}

} // namespace corticle

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/base/vec3.hpp"

#include <cstdint>
#include <span>
#include <vector>

namespace corticle::cloud
{

/// Keeps `count` of many points at random (thesis section 2.4.1): chance decides which, and every part of the body gets
/// its share of them by volume, however dense the points there are. Where even all points of a part are fewer than its
/// share, all are kept. Nothing keeps two chosen points apart.
/// @param points  finite [mm]
/// @return indices of the kept points, ascending
/// @throws InputError when count is not from 1 to the number of points
std::vector<std::int32_t> thin_random(std::span<const Vec3> points, std::int64_t count, std::uint64_t seed);

/// Keeps `count` of many points, evenly spread whatever their density: takes away, one at a time, the point that is the
/// most crowded by those left (weighted sample elimination, Yuksel 2015). It chooses from two to
/// five times as many, taken at random at an even density.
/// @param points  finite [mm]
/// @param seed    decides between points that are equally crowded
/// @return indices of the kept points, ascending
/// @throws InputError when count is not from 1 to the number of points
std::vector<std::int32_t> thin_uniform(std::span<const Vec3> points, std::int64_t count, std::uint64_t seed);

/// thin_random for points whose volumes are known [mm³], as those of the nodes of a mesh are.
std::vector<std::int32_t> thin_random_by_volume(std::span<const Vec3> points, std::span<const double> volumes,
                                                std::int64_t count, std::uint64_t seed);

/// thin_uniform for points whose volumes are known [mm³], beside `fixed` points, which crowd the others and are not
/// counted.
std::vector<std::int32_t> thin_uniform_beside(std::span<const Vec3> fixed, std::span<const Vec3> points,
                                              std::span<const double> volumes, std::int64_t count, std::uint64_t seed);

} // namespace corticle::cloud

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/study/surrogate/design.hpp"

#include "corticle/base/random.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace corticle::fit
{

namespace
{

constexpr int hypercubes_tried = 100;

double squared_distance(const Point& a, const Point& b)
{
    double sum = 0.0;
    for (std::size_t k = 0; k < a.size(); ++k)
    {
        sum += (a[k] - b[k]) * (a[k] - b[k]);
    }
    return sum;
}

double least_squared_distance(const std::vector<Point>& points)
{
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < points.size(); ++i)
    {
        for (std::size_t j = 0; j < i; ++j)
        {
            least = std::min(least, squared_distance(points[i], points[j]));
        }
    }
    return least;
}

std::vector<Point> any_hypercube(std::size_t count, std::size_t dimensions, Random& random)
{
    std::vector<Point> points(count, Point(dimensions));
    std::vector<std::size_t> order(count);
    for (std::size_t k = 0; k < dimensions; ++k)
    {
        std::iota(order.begin(), order.end(), std::size_t{0});
        for (std::size_t i = count; i > 1; --i)
        {
            std::swap(order[i - 1], order[random.index(i)]);
        }
        for (std::size_t i = 0; i < count; ++i)
        {
            points[i][k] = (static_cast<double>(order[i]) + random.uniform()) / static_cast<double>(count);
        }
    }
    return points;
}

} // namespace

double Random::uniform()
{
    return hash_uniform(seed_, counter_++);
}

double Random::normal()
{
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform())); // Box & Muller 1958
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
}

std::size_t Random::index(std::size_t count)
{
    return std::min(count - 1, static_cast<std::size_t>(uniform() * static_cast<double>(count)));
}

std::vector<Point> latin_hypercube(std::size_t count, std::size_t dimensions, std::uint64_t seed)
{
    Random random(seed);
    std::vector<Point> best;
    double best_distance = -1.0;
    for (int i = 0; i < hypercubes_tried; ++i)
    {
        std::vector<Point> points = any_hypercube(count, dimensions, random);
        const double distance = least_squared_distance(points);
        if (distance > best_distance)
        {
            best_distance = distance;
            best = std::move(points);
        }
    }
    return best;
}

std::vector<Point> even_points(std::size_t count, std::size_t dimensions, std::uint64_t seed)
{
    const double power = 1.0 / (static_cast<double>(dimensions) + 1.0);
    double ratio = 1.5; // solves ratio^(d + 1) = ratio + 1
    for (int i = 0; i < 100; ++i)
    {
        ratio = std::pow(1.0 + ratio, power);
    }
    Random random(seed);
    Point shift(dimensions);
    std::ranges::generate(shift, [&] { return random.uniform(); });
    std::vector<Point> points(count, Point(dimensions));
    for (std::size_t i = 0; i < count; ++i)
    {
        for (std::size_t k = 0; k < dimensions; ++k)
        {
            const double step = std::pow(1.0 / ratio, static_cast<double>(k + 1));
            const double place = shift[k] + static_cast<double>(i + 1) * step;
            points[i][k] = place - std::floor(place);
        }
    }
    return points;
}

} // namespace corticle::fit

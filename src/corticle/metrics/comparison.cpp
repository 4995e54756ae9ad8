// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/comparison.hpp"

#include "corticle/base/mat3.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/geometry/surface_tree.hpp"
#include "corticle/mesh/cell_grid.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace corticle::metrics
{

namespace
{

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double same_point = 1e-6;      // in spacings
constexpr double reach = 2.0;            // in spacings
constexpr std::int32_t no_point = -1;    // none to leave out
constexpr double slope_threshold = 1e-3; // least spread of the neighbours, over the largest, that carries a slope

bool have_same_points(const PointField& a, const PointField& b)
{
    const double tolerance = same_point * std::min(a.spacing, b.spacing);
    return std::equal(a.origins.begin(), a.origins.end(), b.origins.begin(), b.origins.end(),
                      [&](const Vec3& p, const Vec3& q) { return squared_norm(p - q) <= tolerance * tolerance; });
}

/// Values of a field between its points.
class Interpolator
{
  public:
    explicit Interpolator(const PointField& field)
        : field_(field), reach_(reach * field.spacing), grid_(field.origins, reach_)
    {
    }

    /// The value at a place, without the point `left_out`; NaN where no point is near.
    double at(const Vec3& place, std::int32_t left_out = no_point) const
    {
        Moments m;
        double nearest = nan;
        grid_.near(place,
                   [&](std::int32_t index, const Vec3& position)
                   {
                       const double distance = norm(position - place);
                       if (index == left_out || !(distance < reach_))
                       {
                           return;
                       }
                       const double value = field_.values[static_cast<std::size_t>(index)];
                       if (distance <= same_point * field_.spacing)
                       {
                           nearest = value;
                       }
                       const double share = (1.0 - distance / reach_) / std::max(distance, 1e-12 * reach_);
                       m.add(share * share, position - place, value);
                   });
        return std::isnan(nearest) ? m.value_at_origin() : nearest;
    }

  private:
    /// Weighted sums over the points near a place, which is the origin.
    struct Moments
    {
        double weight = 0.0;
        double value = 0.0;
        Vec3 place;
        Vec3 place_value;
        Mat3 place_place;
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();

        void add(double w, const Vec3& p, double v)
        {
            weight += w;
            value += w * v;
            place += w * p;
            place_value += (w * v) * p;
            place_place += w * outer(p, p);
            low = std::min(low, v);
            high = std::max(high, v);
        }

        double value_at_origin() const
        {
            if (!(weight > 0.0))
            {
                return nan;
            }
            const double mean_value = value / weight;
            const Vec3 mean_place = place / weight;
            const Mat3 spread = (1.0 / weight) * place_place - outer(mean_place, mean_place);
            // Points on a line or in a plane carry no slope.
            const double third = trace(spread) / 3.0;
            if (!(determinant(spread) > slope_threshold * third * third * third))
            {
                return mean_value;
            }
            const Vec3 slope = inverse(spread) * (place_value / weight - mean_value * mean_place);
            return std::clamp(mean_value - dot(slope, mean_place), low, high);
        }
    };

    const PointField& field_;
    double reach_;
    CellGrid grid_;
};

/// Sum, largest and number of absolute differences; NaN are left out.
struct Differences
{
    double sum = 0.0;
    double largest = 0.0;
    double count = 0.0;

    void add(double difference)
    {
        if (!std::isnan(difference))
        {
            sum += std::abs(difference);
            largest = std::max(largest, std::abs(difference));
            count += 1.0;
        }
    }
    void join(const Differences& other)
    {
        sum += other.sum;
        largest = std::max(largest, other.largest);
        count += other.count;
    }
    double mean() const { return count > 0.0 ? sum / count : nan; }
};

/// Mean of two numbers; where one is NaN, the other.
double mean_of(double a, double b)
{
    return std::isnan(a) ? b : (std::isnan(b) ? a : 0.5 * (a + b));
}

/// Of difference(i) for each i of [0, count).
template <class Difference>
Differences differences(std::size_t count, Difference&& difference)
{
    return parallel_reduce(
        static_cast<std::int64_t>(count), Differences{},
        [&](std::int64_t begin, std::int64_t end)
        {
            Differences part;
            for (std::int64_t i = begin; i < end; ++i)
            {
                part.add(difference(static_cast<std::size_t>(i)));
            }
            return part;
        },
        [](Differences& total, const Differences& part) { total.join(part); });
}

Differences differences_at_points(const PointField& field, const Interpolator& other)
{
    return differences(field.values.size(),
                       [&](std::size_t i) { return field.values[i] - other.at(field.origins[i]); });
}

Differences leave_one_out(const PointField& field, const Interpolator& itself)
{
    return differences(field.values.size(), [&](std::size_t i)
                       { return field.values[i] - itself.at(field.origins[i], static_cast<std::int32_t>(i)); });
}

struct WeightedDistance
{
    double distance;
    double weight;
};

/// Of each vertex of `from` to the surface.
void append_distances(const SurfaceView& from, const geometry::SurfaceTree& surface,
                      std::vector<WeightedDistance>& distances)
{
    const std::vector<double> areas = vertex_areas(from.vertices, from.triangles);
    const std::size_t first = distances.size();
    distances.resize(first + from.vertices.size());
    parallel_for(std::ssize(from.vertices),
                 [&](std::int64_t signed_i)
                 {
                     const auto i = static_cast<std::size_t>(signed_i);
                     distances[first + i] = {std::sqrt(surface.closest(from.vertices[i]).squared_distance), areas[i]};
                 });
}

} // namespace

double percent_difference(double a, double b)
{
    if (a == b)
    {
        return 0.0;
    }
    return a == 0.0 || !std::isfinite(a) || !std::isfinite(b) ? nan : 100.0 * (b - a) / std::abs(a);
}

bool is_share(std::string_view key)
{
    return key.starts_with("asymmetry") || key.ends_with("_share");
}

double telling_percent(std::string_view key, double a, double b, double scale)
{
    constexpr double least_of_other = 0.01;
    constexpr double least_of_scale = 1e-6;
    const double least = std::max(least_of_other * std::abs(b), least_of_scale * scale);
    const bool is_near_zero = a != b && std::abs(a) < least;
    return is_share(key) || is_near_zero ? nan : percent_difference(a, b);
}

double interpolate(std::span<const double> x, std::span<const double> y, double at)
{
    const auto above = std::lower_bound(x.begin(), x.end(), at);
    if (above == x.end() || std::isnan(at))
    {
        return nan;
    }
    const auto right = static_cast<std::size_t>(above - x.begin());
    if (*above == at)
    {
        return y[right];
    }
    if (right == 0)
    {
        return nan;
    }
    const double share = (at - x[right - 1]) / (x[right] - x[right - 1]);
    return (1.0 - share) * y[right - 1] + share * y[right];
}

FieldDifference mean_difference(const PointField& a, const PointField& b)
{
    FieldDifference result;
    if (have_same_points(a, b))
    {
        const Differences all = differences(a.values.size(), [&](std::size_t i) { return a.values[i] - b.values[i]; });
        result.mean = all.mean();
        result.largest = all.largest;
        return result;
    }
    const Interpolator of_a(a);
    const Interpolator of_b(b);
    const Differences at_a = differences_at_points(a, of_b);
    const Differences at_b = differences_at_points(b, of_a);
    result.is_interpolated = true;
    result.mean = mean_of(at_a.mean(), at_b.mean());
    result.largest = at_a.count + at_b.count > 0.0 ? std::max(at_a.largest, at_b.largest) : nan;
    result.compared_share = (at_a.count + at_b.count) / static_cast<double>(a.values.size() + b.values.size());
    result.interpolation_error = mean_of(leave_one_out(a, of_a).mean(), leave_one_out(b, of_b).mean());
    return result;
}

SurfaceDistance surface_distance(const SurfaceView& a, const SurfaceView& b)
{
    std::vector<WeightedDistance> distances;
    append_distances(a, geometry::SurfaceTree(b.vertices, b.triangles), distances);
    append_distances(b, geometry::SurfaceTree(a.vertices, a.triangles), distances);
    std::stable_sort(distances.begin(), distances.end(),
                     [](const WeightedDistance& p, const WeightedDistance& q) { return p.distance < q.distance; });
    double area = 0.0;
    SurfaceDistance result;
    for (const WeightedDistance& d : distances)
    {
        area += d.weight;
        result.mean += d.weight * d.distance;
    }
    result.mean = area > 0.0 ? result.mean / area : nan;
    double reached = 0.0;
    for (const WeightedDistance& d : distances)
    {
        reached += d.weight;
        result.percentile_95 = d.distance;
        if (reached >= 0.95 * area)
        {
            break;
        }
    }
    result.hausdorff = distances.back().distance;
    return result;
}

} // namespace corticle::metrics

// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/mask_cleanup.hpp"

#include "corticle/base/error.hpp"
#include "corticle/imaging/distance_transform.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace corticle::imaging
{

namespace
{

using Box = std::array<std::array<std::int64_t, 2>, 3>; ///< first and last voxel along each axis

/// "1 (250 voxels), 2 (30 voxels)": at most 40 of them.
std::string present_labels(const LabelVolume& image)
{
    constexpr std::size_t most = 40;
    std::map<std::int32_t, std::int64_t> counts;
    for (const std::int32_t label : image.labels)
    {
        ++counts[label];
    }
    std::string list;
    std::size_t listed = 0;
    for (const auto& [label, count] : counts)
    {
        if (listed == most)
        {
            return list + fmt::format(" and {} more", counts.size() - most);
        }
        list += fmt::format("{}{} ({} voxels)", listed == 0 ? "" : ", ", label, count);
        ++listed;
    }
    return list;
}

/// Whether the label of a voxel is chosen.
class Choice
{
  public:
    explicit Choice(std::span<const std::int64_t> labels) : labels_(labels.begin(), labels.end())
    {
        std::sort(labels_.begin(), labels_.end());
    }
    bool operator()(std::int32_t label) const
    {
        return labels_.empty() ? label != 0 : std::binary_search(labels_.begin(), labels_.end(), label);
    }

  private:
    std::vector<std::int64_t> labels_;
};

bool is_end(std::int64_t at, std::int64_t size)
{
    return at == 0 || at == size - 1;
}

void require_labels(const LabelVolume& image, std::span<const std::int64_t> labels)
{
    std::set<std::int64_t> missing(labels.begin(), labels.end());
    for (const std::int32_t label : image.labels)
    {
        if (missing.empty())
        {
            return;
        }
        missing.erase(label);
    }
    if (!missing.empty())
    {
        throw InputError(
            fmt::format("label image: no voxel has label {}; there are {}", *missing.begin(), present_labels(image)));
    }
}

/// Where every label but 0 is the body, 0 must be the background: not another number, below 0 or along the border.
void require_background(const LabelVolume& image)
{
    const auto negative = std::find_if(image.labels.begin(), image.labels.end(), [](std::int32_t l) { return l < 0; });
    if (negative != image.labels.end())
    {
        throw InputError(fmt::format("label image: label {} is below 0; expected background 0, or a choice of labels; "
                                     "there are {}",
                                     *negative, present_labels(image)));
    }
    constexpr double largest_share = 0.5;
    const auto& size = image.size;
    std::int64_t border = 0;
    std::int64_t labelled = 0;
    for (std::size_t k = 0; k < image.labels.size(); ++k)
    {
        const auto at = static_cast<std::int64_t>(k);
        const bool is_border = is_end(at % size[0], size[0]) || is_end(at / size[0] % size[1], size[1]) ||
                               is_end(at / (size[0] * size[1]), size[2]);
        border += is_border ? 1 : 0;
        labelled += is_border && image.labels[k] != 0 ? 1 : 0;
    }
    const double share = static_cast<double>(labelled) / static_cast<double>(border);
    if (share > largest_share)
    {
        throw InputError(fmt::format("label image: {:.3g} % of the voxels on its border have a label other than 0, so "
                                     "the mask has no background; expected a choice of labels; there are {}",
                                     100.0 * share, present_labels(image)));
    }
}

Box bounding_box(const LabelVolume& image, const Choice& chosen)
{
    Box box;
    box.fill({std::numeric_limits<std::int64_t>::max(), -1});
    std::size_t k = 0;
    for (std::int64_t z = 0; z < image.size[2]; ++z)
    {
        for (std::int64_t y = 0; y < image.size[1]; ++y)
        {
            for (std::int64_t x = 0; x < image.size[0]; ++x, ++k)
            {
                if (chosen(image.labels[k]))
                {
                    const std::array<std::int64_t, 3> at{x, y, z};
                    for (int axis = 0; axis < 3; ++axis)
                    {
                        box[axis] = {std::min(box[axis][0], at[axis]), std::max(box[axis][1], at[axis])};
                    }
                }
            }
        }
    }
    return box;
}

/// Visits the voxels that paths through faces connect with `start`, for which `enter(voxel)` says yes (and marks them).
template <class Enter>
std::int64_t flood(const VoxelGrid& grid, std::int64_t start, std::vector<std::int64_t>& stack, Enter&& enter)
{
    std::int64_t visited = 0;
    stack.assign(1, start);
    while (!stack.empty())
    {
        const std::int64_t voxel = stack.back();
        stack.pop_back();
        ++visited;
        const auto at = grid.coordinates(voxel);
        for (int axis = 0; axis < 3; ++axis)
        {
            const std::int64_t stride = grid.stride(axis);
            if (at[axis] > 0 && enter(voxel - stride))
            {
                stack.push_back(voxel - stride);
            }
            if (at[axis] + 1 < grid.size[axis] && enter(voxel + stride))
            {
                stack.push_back(voxel + stride);
            }
        }
    }
    return visited;
}

} // namespace

GridMask select_labels(const LabelVolume& image, std::span<const std::int64_t> labels, double margin_mm)
{
    require_labels(image, labels);
    const Choice chosen(labels);
    const Box box = bounding_box(image, chosen);
    if (box[0][1] < 0)
    {
        throw InputError(fmt::format("label image: every voxel is background; there are {}", present_labels(image)));
    }
    if (labels.empty())
    {
        require_background(image);
    }
    GridMask result;
    VoxelGrid& grid = result.grid;
    result.middle_x =
        image.frame
            .position({0.5 * static_cast<double>(image.size[0] - 1), 0.5 * static_cast<double>(image.size[1] - 1),
                       0.5 * static_cast<double>(image.size[2] - 1)})
            .x;
    const Vec3 edges = voxel_edges(image.frame);
    std::array<std::int64_t, 3> first{};
    for (int axis = 0; axis < 3; ++axis)
    {
        const auto margin = static_cast<std::int64_t>(std::ceil(margin_mm / edges[axis])) + 3;
        first[axis] = box[axis][0] - margin;
        grid.size[axis] = box[axis][1] + margin + 1 - first[axis];
        result.touches_border = result.touches_border || box[axis][0] == 0 || box[axis][1] == image.size[axis] - 1;
    }
    grid.frame.linear = image.frame.linear;
    grid.frame.origin = image.frame.position(
        {static_cast<double>(first[0]), static_cast<double>(first[1]), static_cast<double>(first[2])});
    result.mask.assign(static_cast<std::size_t>(grid.count()), 0);
    for (std::int64_t z = box[2][0]; z <= box[2][1]; ++z)
    {
        for (std::int64_t y = box[1][0]; y <= box[1][1]; ++y)
        {
            for (std::int64_t x = box[0][0]; x <= box[0][1]; ++x)
            {
                const bool inside = chosen(image.labels[(z * image.size[1] + y) * image.size[0] + x]);
                result.mask[grid.index(x - first[0], y - first[1], z - first[2])] = inside ? 1 : 0;
            }
        }
    }
    return result;
}

ComponentSizes keep_largest_component(const VoxelGrid& grid, Mask& mask)
{
    require_voxels(grid, "mask", mask.size());
    std::vector<std::int64_t> stack;
    ComponentSizes sizes;
    std::int64_t start_of_largest = 0;
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        if (mask[voxel] != 1)
        {
            continue;
        }
        ++sizes.count;
        mask[voxel] = 2;
        const std::int64_t visited =
            flood(grid, voxel, stack, [&](std::int64_t v) { return mask[v] == 1 ? (mask[v] = 2, true) : false; });
        sizes.voxels += visited;
        if (visited > sizes.largest)
        {
            sizes.second = std::exchange(sizes.largest, visited);
            start_of_largest = voxel;
        }
        else
        {
            sizes.second = std::max(sizes.second, visited);
        }
    }
    if (sizes.count > 0)
    {
        mask[start_of_largest] = 1;
        flood(grid, start_of_largest, stack,
              [&](std::int64_t v) { return mask[v] == 2 ? (mask[v] = 1, true) : false; });
        std::replace(mask.begin(), mask.end(), std::uint8_t{2}, std::uint8_t{0});
    }
    return sizes;
}

void keep_components_of(const VoxelGrid& grid, const Mask& seeds, Mask& mask)
{
    require_voxels(grid, "mask", mask.size());
    require_voxels(grid, "seeds", seeds.size());
    std::vector<std::int64_t> stack;
    for (std::int64_t voxel = 0; voxel < grid.count(); ++voxel)
    {
        if (mask[voxel] == 1 && seeds[voxel] == 1)
        {
            mask[voxel] = 2;
            flood(grid, voxel, stack, [&](std::int64_t v) { return mask[v] == 1 ? (mask[v] = 2, true) : false; });
        }
    }
    std::transform(mask.begin(), mask.end(), mask.begin(),
                   [](std::uint8_t voxel) { return static_cast<std::uint8_t>(voxel == 2); });
}

void close_mask(const VoxelGrid& grid, double radius, Mask& mask)
{
    // A hair more, so that a radius of one voxel reaches the next one whatever the rounding of the voxel's size.
    const auto reach = static_cast<float>(radius * radius * 1.0001);
    const std::vector<float> to_mask = squared_distance_to(grid, mask, 1);
    Mask dilated(mask.size());
    std::transform(to_mask.begin(), to_mask.end(), dilated.begin(),
                   [&](float distance) { return static_cast<std::uint8_t>(distance <= reach); });
    const std::vector<float> to_rest = squared_distance_to(grid, dilated, 0);
    std::transform(to_rest.begin(), to_rest.end(), mask.begin(), mask.begin(),
                   [&](float distance, std::uint8_t inside)
                   { return static_cast<std::uint8_t>(inside == 1 || distance > reach); });
}

void fill_cavities(const VoxelGrid& grid, Mask& mask)
{
    require_voxels(grid, "mask", mask.size());
    std::vector<std::int64_t> stack;
    mask[0] = 2;
    flood(grid, 0, stack, [&](std::int64_t v) { return mask[v] == 0 ? (mask[v] = 2, true) : false; });
    std::transform(mask.begin(), mask.end(), mask.begin(),
                   [](std::uint8_t voxel) { return static_cast<std::uint8_t>(voxel != 2); });
}

} // namespace corticle::imaging

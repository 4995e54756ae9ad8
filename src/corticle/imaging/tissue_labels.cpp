// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/tissue_labels.hpp"

#include "corticle/base/error.hpp"
#include "corticle/base/parallel.hpp"
#include "corticle/imaging/distance_transform.hpp"
#include "corticle/imaging/mask_cleanup.hpp"
#include "corticle/imaging/smoothing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace corticle::imaging
{

namespace
{

using material::TissueKind;

/// Tissue of every label in a list.
std::map<std::int64_t, TissueKind> tissue_of_label(const TissueLabels& labels)
{
    std::map<std::int64_t, TissueKind> result;
    for (std::size_t kind = 0; kind < labels.size(); ++kind)
    {
        for (const std::int64_t label : labels[kind])
        {
            result.emplace(label, static_cast<TissueKind>(kind));
        }
    }
    return result;
}

/// Label of the voxel of the image in which a point lies; 0 beyond the image.
std::int32_t label_at(const LabelVolume& image, const Mat3& to_index, const Vec3& point)
{
    const Vec3 index = to_index * (point - image.frame.origin);
    std::int64_t at = 0;
    for (int axis = 2; axis >= 0; --axis)
    {
        const auto k = static_cast<std::int64_t>(std::lround(index[axis]));
        if (k < 0 || k >= image.size[axis])
        {
            return 0;
        }
        at = at * image.size[axis] + k;
    }
    return image.labels[static_cast<std::size_t>(at)];
}

std::vector<float> distance_to(const VoxelGrid& grid, const Mask& mask)
{
    std::vector<float> distance = squared_distance_to(grid, mask, 1);
    std::ranges::transform(distance, distance.begin(), [](float squared) { return std::sqrt(squared); });
    return distance;
}

/// Masks of the tissues on the grid of the body.
material::PerTissue<Mask> tissue_masks(const LabelVolume& image, const TissueLabels& labels, const GridMask& body,
                                       std::string& note)
{
    const std::map<std::int64_t, TissueKind> tissues = tissue_of_label(labels);
    material::PerTissue<Mask> masks;
    masks.fill(Mask(body.mask.size(), 0));
    std::set<std::int32_t> unlisted;
    std::int64_t unlisted_voxels = 0;
    const Mat3 to_index = inverse(image.frame.linear);
    for (std::size_t voxel = 0; voxel < body.mask.size(); ++voxel)
    {
        if (body.mask[voxel] == 0)
        {
            continue;
        }
        const std::int32_t label = label_at(image, to_index, body.grid.position(static_cast<std::int64_t>(voxel)));
        const auto found = tissues.find(label);
        if (found == tissues.end())
        {
            unlisted.insert(label);
            ++unlisted_voxels;
        }
        const TissueKind kind = found == tissues.end() ? TissueKind::white : found->second;
        masks[static_cast<std::size_t>(kind)][voxel] = 1;
    }
    if (!unlisted.empty())
    {
        note = fmt::format("tissue.labels: {} voxels of the body have a label in no list, {} the first of {}; they "
                           "count as white matter",
                           unlisted_voxels, *unlisted.begin(), unlisted.size());
    }
    return masks;
}

} // namespace

TissueReader::TissueReader(const LabelVolume& image, const TissueLabels& labels, std::span<const std::int64_t> body,
                           double smoothing_mm)
{
    for (const std::vector<std::int64_t>& list : labels)
    {
        if (!list.empty())
        {
            select_labels(image, list, 0.0); // refuses labels that no voxel has
        }
    }
    const GridMask whole = select_labels(image, body, 6.0 * smoothing_mm + 2.0);
    grid_ = whole.grid;
    const material::PerTissue<Mask> masks = tissue_masks(image, labels, whole, note);
    constexpr auto cortex = static_cast<std::size_t>(TissueKind::cortex);
    Mask other(whole.mask.size(), 0);
    for (std::size_t kind = 0; kind < masks.size(); ++kind)
    {
        if (kind != cortex && voxel_count(masks[kind]) > 0)
        {
            distance_[kind] = distance_to(grid_, masks[kind]);
            std::ranges::transform(other, masks[kind], other.begin(), std::bit_or<>{});
        }
    }
    if (voxel_count(masks[cortex]) == 0 || voxel_count(other) == 0)
    {
        throw InputError(fmt::format("tissue.labels: the body has {} voxels of cortex and {} of other tissue; expected "
                                     "both",
                                     voxel_count(masks[cortex]), voxel_count(other)));
    }
    const std::vector<float> to_cortex = distance_to(grid_, masks[cortex]);
    cortex_inside_ = distance_to(grid_, other);
    const auto half = static_cast<float>(0.5 * std::cbrt(grid_.voxel_volume()));
    for (std::size_t voxel = 0; voxel < cortex_inside_.size(); ++voxel)
    {
        // Beyond the body too, so that distances go on across its surface.
        cortex_inside_[voxel] =
            to_cortex[voxel] <= cortex_inside_[voxel] ? cortex_inside_[voxel] - half : half - to_cortex[voxel];
    }
    smooth_gaussian(grid_, smoothing_mm, cortex_inside_);
}

/// Linear between the eight centres about a point.
double TissueReader::interpolated(std::span<const float> values, const Vec3& point) const
{
    const Vec3 index = inverse(grid_.frame.linear) * (point - grid_.frame.origin);
    std::array<std::int64_t, 3> low{};
    Vec3 part;
    for (int axis = 0; axis < 3; ++axis)
    {
        const double place = std::clamp(index[axis], 0.0, static_cast<double>(grid_.size[axis] - 1));
        low[axis] = std::min(static_cast<std::int64_t>(place), grid_.size[axis] - 2);
        part[axis] = place - static_cast<double>(low[axis]);
    }
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner)
    {
        double weight = 1.0;
        std::int64_t at = grid_.index(low[0], low[1], low[2]);
        for (int axis = 0; axis < 3; ++axis)
        {
            const bool is_high = (corner >> axis & 1) == 1;
            weight *= is_high ? part[axis] : 1.0 - part[axis];
            at += is_high ? grid_.stride(axis) : 0;
        }
        sum += weight * static_cast<double>(values[static_cast<std::size_t>(at)]);
    }
    return sum;
}

LabelledPoints TissueReader::at(std::span<const Vec3> points) const
{
    LabelledPoints result;
    result.cortex_inside.resize(points.size());
    result.tissue.resize(points.size());
    parallel_for(std::ssize(points),
                 [&](std::int64_t i)
                 {
                     result.cortex_inside[i] = interpolated(cortex_inside_, points[i]);
                     double nearest = std::numeric_limits<double>::infinity();
                     for (std::size_t kind = 0; kind < distance_.size(); ++kind)
                     {
                         const double distance = distance_[kind].empty() ? std::numeric_limits<double>::infinity()
                                                                         : interpolated(distance_[kind], points[i]);
                         if (distance < nearest)
                         {
                             nearest = distance;
                             result.tissue[i] = static_cast<TissueKind>(kind);
                         }
                     }
                 });
    return result;
}

} // namespace corticle::imaging

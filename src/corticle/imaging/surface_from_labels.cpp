// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/surface_from_labels.hpp"

#include "corticle/base/box.hpp"
#include "corticle/base/error.hpp"
#include "corticle/geometry/self_intersections.hpp"
#include "corticle/imaging/handles.hpp"
#include "corticle/imaging/hemisphere.hpp"
#include "corticle/imaging/kuhn_grid.hpp"
#include "corticle/imaging/marching_tetrahedra.hpp"
#include "corticle/imaging/mask_cleanup.hpp"
#include "corticle/imaging/smoothing.hpp"
#include "corticle/imaging/taubin_smoothing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace corticle::imaging
{

namespace
{

/// How far from the level the values of voxels are kept whose side was changed: the surface then passes about a third
/// of a voxel from them, and the banks of a cut stand apart.
constexpr float value_gap = 0.15F;
constexpr double clearance = 0.1; ///< of the surface from voxel centres, in voxels: see marching_tetrahedra
constexpr int taubin_sweeps = 8;
constexpr double least_component = 0.8; ///< share of the mask that its largest component must hold
constexpr double like_size = 0.5;       ///< share of the largest that makes the next one a hemisphere, perhaps
constexpr double much = 0.2;            ///< share of the mask that a step may remove without a warning
constexpr double most = 0.5;            ///< share beyond which it is no longer the same body

void require_range(const char* key, double value, double high)
{
    if (!(value >= 0.0 && value <= high))
    {
        throw InputError(fmt::format("{} = {:g}; expected 0 to {:g} mm", key, value, high));
    }
}

void require_options(const MaskOptions& options)
{
    require_range("closing_mm", options.closing_mm, 10.0);
    require_range("smoothing_mm", options.smoothing_mm, 5.0);
}

void require_size(const LabelVolume& image)
{
    const bool fits = image.size[0] > 0 && image.size[1] > 0 && image.size[2] > 0 &&
                      static_cast<std::int64_t>(image.labels.size()) == image.size[0] * image.size[1] * image.size[2];
    const double voxel_volume = std::abs(determinant(image.frame.linear));
    if (!fits || !(voxel_volume > 0.0) || !std::isfinite(voxel_volume) || !is_finite(image.frame.origin))
    {
        throw InputError(fmt::format("label image: {} x {} x {} voxels with {} labels and voxels of {:g} mm³; expected "
                                     "a label for each voxel and a positive volume",
                                     image.size[0], image.size[1], image.size[2], image.labels.size(), voxel_volume));
    }
}

/// The steps from labels to the surface, in their order; each notes in the report what it changed.
class SurfaceBuilder
{
  public:
    SurfaceBuilder(const LabelVolume& image, const MaskOptions& options) : options_(options)
    {
        GridMask selected = select_labels(image, options.labels, options.closing_mm + 2.0 * options.smoothing_mm);
        grid_ = selected.grid;
        middle_x_ = selected.middle_x;
        mask_ = std::move(selected.mask);
        report_.voxel_mm = voxel_edges(image.frame);
        report_.closing_mm = options.closing_mm;
        report_.smoothing_mm = options.smoothing_mm;
        note("labels", Mask(mask_.size(), 0), mask_);
        if (selected.touches_border)
        {
            report_.warnings.emplace_back(
                "the mask touches the border of the image: the body may be cut off there; it was closed by a plane");
        }
    }

    void clean()
    {
        const bool is_whole = options_.hemisphere == Hemisphere::both;
        is_whole ? change("largest component", [&] { keep_largest("the labels form"); })
                 : change("components of neither hemisphere", [&] { keep_largest_of_each_side(grid_, mask_); });
        if (options_.closing_mm > 0.0)
        {
            change("closing", [&] { close_mask(grid_, options_.closing_mm, mask_); });
        }
        if (options_.fill_cavities)
        {
            change("cavities", [&] { imaging::fill_cavities(grid_, mask_); });
        }
        values_.assign(mask_.begin(), mask_.end());
        if (!is_whole)
        {
            change("hemisphere", [&] { cut_hemisphere(); });
            change("largest component",
                   [&] { keep_largest(fmt::format("the {} half forms", name_of(options_.hemisphere))); });
            drop_values_outside();
        }
        require_voxels();
        double voxels = 0.0;
        for (const float value : values_)
        {
            voxels += static_cast<double>(value);
        }
        report_.mask_volume_mm3 = voxels * grid_.voxel_volume();
    }

    void smooth()
    {
        smooth_gaussian(grid_, options_.smoothing_mm, values_);
        find_level();
        change("smoothing",
               [&]
               {
                   std::transform(values_.begin(), values_.end(), mask_.begin(),
                                  [&](float value) { return static_cast<std::uint8_t>(value > level_); });
               });
        require_voxels();
        change("loose parts", [&] { drop_loose_parts(); });
        change("cavities after smoothing", [&] { fill_closed_cavities(); });
    }

    void make_ball()
    {
        report_.genus_before = 1 - euler_characteristic(grid_, mask_);
        report_.genus = report_.genus_before;
        if (report_.genus_before > 0 && options_.remove_handles)
        {
            change("handles",
                   [&]
                   {
                       BallMask ball = remove_handles(grid_, mask_, values_, level_);
                       mask_ = std::move(ball.mask);
                       report_.handles = std::move(ball.changes);
                   });
            report_.genus = 0;
        }
    }

    ImagedSurface extract()
    {
        for (std::size_t voxel = 0; voxel < values_.size(); ++voxel)
        {
            const bool inside = values_[voxel] > level_;
            if (inside != (mask_[voxel] == 1))
            {
                values_[voxel] = level_ + (inside ? -value_gap : value_gap);
            }
        }
        ImagedSurface result{marching_tetrahedra(grid_, values_, level_, clearance), {}};
        TriangleMesh smoothed = result.surface;
        smooth_taubin(smoothed, taubin_sweeps);
        if (geometry::self_intersections(smoothed).empty())
        {
            result.surface = std::move(smoothed);
        }
        else
        {
            report_.warnings.emplace_back("the surface was left with its voxel steps: smoothing them away would have "
                                          "made it cross itself");
        }
        measure(result.surface);
        result.report = std::move(report_);
        return result;
    }

  private:
    template <class Change>
    void change(const char* name, Change&& apply)
    {
        const Mask before = mask_;
        apply();
        note(name, before, mask_);
        if (name != std::string_view("hemisphere"))
        {
            judge_loss(voxel_count(before));
        }
    }

    /// Of the step noted last.
    void judge_loss(std::int64_t before)
    {
        const MaskStep& step = report_.steps.back();
        const double share = static_cast<double>(step.removed) / static_cast<double>(std::max<std::int64_t>(before, 1));
        if (share > most && step.removed < before) // where nothing is left, that is said
        {
            throw InputError(fmt::format("label image: the step \"{}\" removes {:.3g} % of the mask, {} of {} voxels; "
                                         "expected a body that keeps most of it",
                                         step.name, 100.0 * share, step.removed, before));
        }
        if (share > much)
        {
            report_.warnings.push_back(
                fmt::format("the step \"{}\" removed {:.3g} % of the mask", step.name, 100.0 * share));
        }
    }

    void note(const char* name, const Mask& before, const Mask& after)
    {
        MaskStep step{name, 0, 0, 0.0, 0.0};
        for (std::size_t voxel = 0; voxel < before.size(); ++voxel)
        {
            step.added += before[voxel] < after[voxel] ? 1 : 0;
            step.removed += before[voxel] > after[voxel] ? 1 : 0;
        }
        step.added_mm3 = static_cast<double>(step.added) * grid_.voxel_volume();
        step.removed_mm3 = static_cast<double>(step.removed) * grid_.voxel_volume();
        report_.steps.push_back(step);
    }

    void require_voxels() const
    {
        if (voxel_count(mask_) == 0)
        {
            throw InputError(fmt::format("label image: nothing is left of the mask after {}; expected a body of some "
                                         "voxels (smaller smoothing_mm keeps more)",
                                         report_.steps.back().name));
        }
    }

    /// @param subject  what forms components, as in "the labels form"
    void keep_largest(const std::string& subject)
    {
        const ComponentSizes sizes = keep_largest_component(grid_, mask_);
        const double largest = static_cast<double>(sizes.largest) / static_cast<double>(sizes.voxels);
        if (largest < least_component)
        {
            const double second = static_cast<double>(sizes.second) / static_cast<double>(sizes.voxels);
            const bool are_two = second >= like_size * largest && largest + second >= least_component;
            throw InputError(fmt::format(
                "label image: {} {} components that share no face, the largest holds {:.3g} % of the voxels{}; "
                "expected "
                "one of at least {:g} %",
                subject, sizes.count, 100.0 * largest,
                are_two && options_.hemisphere == Hemisphere::both
                    ? fmt::format(" and the next {:.3g} %: if they are the hemispheres, hemisphere = \"left\" or "
                                  "\"right\" takes one, or add the label that joins them",
                                  100.0 * second)
                    : std::string(),
                100.0 * least_component));
        }
        if (sizes.count > 1)
        {
            report_.warnings.push_back(fmt::format("{} {} components; all but the largest, which holds {:.4g} % of the "
                                                   "voxels, were dropped",
                                                   subject, sizes.count, 100.0 * largest));
        }
    }

    /// Of voxels that the cut left by less than half, those next to the mask count on.
    void drop_values_outside()
    {
        for (std::size_t voxel = 0; voxel < values_.size(); ++voxel)
        {
            values_[voxel] = values_[voxel] >= 0.5F && mask_[voxel] == 0 ? 0.0F : values_[voxel];
        }
    }

    /// Voxels that the plane cuts count by the share on the wanted side, so that the cut is no staircase.
    void cut_hemisphere()
    {
        const Plane plane = midsagittal_plane(grid_, mask_);
        require_both_hemispheres({grid_, mask_, false, middle_x_}, plane, name_of(options_.hemisphere),
                                 report_.warnings);
        const double side = options_.hemisphere == Hemisphere::right ? 1.0 : -1.0;
        const double width = std::cbrt(grid_.voxel_volume());
        for (std::int64_t voxel = 0; voxel < grid_.count(); ++voxel)
        {
            const double height = side * (dot(plane.normal, grid_.position(voxel)) - plane.offset);
            values_[voxel] *= static_cast<float>(std::clamp(0.5 + height / width, 0.0, 1.0));
            mask_[voxel] = values_[voxel] >= 0.5F ? 1 : 0;
        }
    }

    /// The level whose surface encloses the volume of the mask.
    void find_level()
    {
        double low = 0.02;
        double high = 0.98;
        for (int halving = 0; halving < 14; ++halving)
        {
            const double middle = 0.5 * (low + high);
            const TriangleMesh surface = marching_tetrahedra(grid_, values_, static_cast<float>(middle));
            const bool too_large = enclosed_volume(surface.vertices, surface.triangles) > report_.mask_volume_mm3;
            (too_large ? low : high) = middle;
        }
        level_ = static_cast<float>(0.5 * (low + high));
        report_.iso_level = static_cast<double>(level_);
    }

    void drop_loose_parts()
    {
        const Components parts = kuhn_components(grid_, mask_, 1);
        const auto largest = std::max_element(parts.sizes.begin(), parts.sizes.end()) - parts.sizes.begin();
        std::transform(parts.number.begin(), parts.number.end(), mask_.begin(),
                       [&](std::int32_t number) { return static_cast<std::uint8_t>(number == largest); });
    }

    /// Components of the background other than that of the outermost layer, which comes first.
    void fill_closed_cavities()
    {
        const Components parts = kuhn_components(grid_, mask_, 0);
        std::transform(parts.number.begin(), parts.number.end(), mask_.begin(),
                       [](std::int32_t number) { return static_cast<std::uint8_t>(number != 1); });
    }

    void measure(const TriangleMesh& surface)
    {
        report_.extent_mm = corticle::bounding_box(surface.vertices).size();
        report_.surface_volume_mm3 = enclosed_volume(surface.vertices, surface.triangles);
        report_.surface_area_mm2 = surface_area(surface.vertices, surface.triangles);
    }

    MaskOptions options_;
    VoxelGrid grid_;
    double middle_x_ = 0.0; ///< of the image [mm]
    Mask mask_;
    std::vector<float> values_; ///< of the mask, smoothed
    float level_ = 0.5F;
    MaskReport report_;
};

} // namespace

ImagedSurface surface_from_labels(const LabelVolume& image, const MaskOptions& options)
{
    require_options(options);
    require_size(image);
    SurfaceBuilder builder(image, options);
    builder.clean();
    builder.smooth();
    builder.make_ball();
    return builder.extract();
}

} // namespace corticle::imaging

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/imaging/tissue_labels.hpp"
#include "corticle/model/model.hpp"
#include "corticle/prepare/options.hpp"
#include "corticle/prepare/source_reports.hpp"

namespace corticle::prepare
{

/// The tissues of the label volume that is the body. @throws InputError, one line naming the file
imaging::TissueReader read_tissues(const PreparationOptions& options, std::vector<std::string>& notes);

/// The surface of the body without its cortex, cleaned like that of the body (settled_mask). Empty where there is none
/// in one piece; `notes` says so.
TriangleMesh inner_surface(const PreparationOptions& options, std::vector<std::string>& notes);

/// What the labels say at material points.
/// @param tissue  with depths: the thickness at a point is its depth and the way on to the inner boundary; 0 where no
/// cortex is
void set_labelled_tissue(const imaging::TissueReader& reader, std::span<const Vec3> places,
                         material::TissueFields& tissue);

/// Cortex by labels, tissues and growth by week, where the options ask for them. @param tissue  with volumes
/// @throws InputError for a growth table that cannot be used
void complete_labelled_tissue(const PreparationOptions& options, material::TissueFields& tissue);

/// The thickness that 95 % of the labelled cortex does not exceed, at vertices of the outer surface [mm].
double largest_labelled_thickness(const imaging::TissueReader& reader, std::span<const Vec3> vertices);

/// Mean thickness of the cortex below the outer surface, by area [mm].
double labelled_thickness(const model::Model& model);

/// Of a body with a labelled cortex.
TissueReport report_tissues(const model::Model& model);

} // namespace corticle::prepare

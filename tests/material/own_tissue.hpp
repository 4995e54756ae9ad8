// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"

namespace corticle::test
{

/// A tissue with its options and its state, which a test may change as it likes.
struct OwnTissue : material::TissueFields, material::TissueState
{
    OwnTissue() = default;
    OwnTissue(material::TissueFields fields, const material::TissueOptions& chosen,
              const material::ReferenceSize& thinning = {})
        : material::TissueFields(std::move(fields)), options(chosen), size(thinning)
    {
    }

    material::TissueOptions options;
    material::ReferenceSize size;

    operator material::Tissue() const { return {options, *this, *this}; }
    material::MaterialPoint point(std::size_t i, double t) const { return material::Tissue(*this).point(i, t); }
    bool grows_plainly() const { return material::Tissue(*this).grows_plainly(); }
    Vec3 growth_normal(std::size_t i, const Mat3& F) const { return material::Tissue(*this).growth_normal(i, F); }
    void set_layer(double t) { corticle::material::set_layer(*this, options, size, t, *this); }
    /// Free of stress at t, with theta as it is.
    void start_growth(double t)
    {
        material::TissueFields fields = *this;
        fields.given_theta = theta;
        past = material::start_tissue(fields, options, size, t).past;
    }
};

} // namespace corticle::test

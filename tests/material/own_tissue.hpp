// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/material/tissue.hpp"

namespace corticle::test
{

/// A tissue with its options and its state, which a test may change as it likes.
struct OwnTissue : TissueFields, TissueState
{
    OwnTissue() = default;
    OwnTissue(TissueFields fields, const TissueOptions& chosen, const ReferenceSize& thinning = {})
        : TissueFields(std::move(fields)), options(chosen), size(thinning)
    {
    }

    TissueOptions options;
    ReferenceSize size;

    operator Tissue() const { return {options, *this, *this}; }
    MaterialPoint point(std::size_t i, double t) const { return Tissue(*this).point(i, t); }
    bool grows_plainly() const { return Tissue(*this).grows_plainly(); }
    Vec3 growth_normal(std::size_t i, const Mat3& F) const { return Tissue(*this).growth_normal(i, F); }
    void set_layer(double t) { corticle::set_layer(*this, options, size, t, *this); }
    /// Free of stress at t, with theta as it is.
    void start_growth(double t)
    {
        TissueFields fields = *this;
        fields.given_theta = theta;
        past = start_tissue(fields, options, size, t).past;
    }
};

} // namespace corticle::test

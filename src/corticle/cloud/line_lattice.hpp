// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/mesh/triangle_mesh.hpp"

namespace corticle::cloud
{

/// Lines parallel to z on a square lattice over a closed surface, and where each enters and leaves it.
class LineLattice
{
  public:
    LineLattice(const TriangleMesh& surface, double step);

    std::int64_t count() const { return lines_[0] * lines_[1]; }
    double x_of(std::int64_t line) const ///< [mm]
    {
        const std::int64_t row = line / lines_[1];
        return x_ + step_ * static_cast<double>(row);
    }
    double y_of(std::int64_t line) const { return y_ + step_ * static_cast<double>(line % lines_[1]); } ///< [mm]

    /// Heights of the crossings of a line, ascending [mm]; their number is even, the inside lies between the pairs.
    std::span<const double> crossings(std::int64_t line) const
    {
        return std::span(heights_).subspan(begin_[line], begin_[line + 1] - begin_[line]);
    }

  private:
    template <class Visit>
    void visit_crossings(const TriangleMesh& surface, const Triangle& triangle, Visit&& visit) const;

    double x_ = 0.0, y_ = 0.0, step_ = 1.0;
    std::int64_t lines_[2] = {0, 0};
    std::vector<std::size_t> begin_;
    std::vector<double> heights_;
};

} // namespace corticle::cloud

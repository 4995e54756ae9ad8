// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/imaging/marching_tetrahedra.hpp"

#include <algorithm>
#include <bit>
#include <utility>

namespace corticle::imaging
{

namespace
{

/// Corners of the six tetrahedra of a cell, positively oriented; corner k has bits along x, y, z.
constexpr std::array<std::array<int, 4>, 6> cell_tetrahedra{
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}, {0, 5, 1, 7}}};

class Extraction
{
  public:
    Extraction(const VoxelGrid& grid, std::span<const float> values, float level, double clearance)
        : grid_(grid), values_(values), level_(level), clearance_(clearance),
          mirrored_(determinant(grid.frame.linear) < 0.0)
    {
        for (int corner = 0; corner < 8; ++corner)
        {
            offset_[corner] =
                (corner & 1) * grid.stride(0) + (corner >> 1 & 1) * grid.stride(1) + (corner >> 2 & 1) * grid.stride(2);
        }
        // Vertices are found again by the lower end of their edge: only two layers of cells are open at a time.
        for (auto& layer : open_)
        {
            layer.assign(static_cast<std::size_t>(grid.size[0] * grid.size[1] * 7), -1);
        }
    }

    TriangleMesh run()
    {
        for (std::int64_t z = 0; z + 1 < grid_.size[2]; ++z)
        {
            for (std::int64_t y = 0; y + 1 < grid_.size[1]; ++y)
            {
                for (std::int64_t x = 0; x + 1 < grid_.size[0]; ++x)
                {
                    cut_cell(grid_.index(x, y, z));
                }
            }
            std::swap(open_[0], open_[1]);
            std::fill(open_[1].begin(), open_[1].end(), -1);
        }
        return std::move(surface_);
    }

  private:
    bool is_inside(std::int64_t voxel) const { return values_[voxel] > level_; }

    void cut_cell(std::int64_t cell)
    {
        unsigned inside = 0;
        for (int corner = 0; corner < 8; ++corner)
        {
            inside |= static_cast<unsigned>(is_inside(cell + offset_[corner])) << corner;
        }
        if (inside == 0 || inside == 255)
        {
            return;
        }
        cell_ = cell;
        for (const auto& tetrahedron : cell_tetrahedra)
        {
            cut_tetrahedron(tetrahedron, inside);
        }
    }

    void cut_tetrahedron(std::array<int, 4> corners, unsigned inside)
    {
        unsigned set = 0;
        for (int k = 0; k < 4; ++k)
        {
            set |= (inside >> corners[k] & 1U) << k;
        }
        const int count = std::popcount(set);
        if (count == 0 || count == 4)
        {
            return;
        }
        sort_inside_first(corners, inside);
        const auto [a, b, c, d] = corners;
        if (count == 1)
        {
            add(crossing(a, b), crossing(a, c), crossing(a, d));
        }
        else if (count == 3)
        {
            add(crossing(d, a), crossing(d, b), crossing(d, c));
        }
        else
        {
            add_quadrilateral(crossing(a, c), crossing(a, d), crossing(b, d), crossing(b, c));
        }
    }

    /// By an even permutation, so that the orientation stays.
    static void sort_inside_first(std::array<int, 4>& corners, unsigned inside)
    {
        int swaps = 0;
        for (int pass = 0; pass < 3; ++pass)
        {
            for (int k = 0; k < 3; ++k)
            {
                if ((inside >> corners[k] & 1U) == 0 && (inside >> corners[k + 1] & 1U) != 0)
                {
                    std::swap(corners[k], corners[k + 1]);
                    ++swaps;
                }
            }
        }
        if (swaps % 2 == 1)
        {
            const bool last_two_alike = (inside >> corners[2] & 1U) == (inside >> corners[3] & 1U);
            last_two_alike ? std::swap(corners[2], corners[3]) : std::swap(corners[0], corners[1]);
        }
    }

    /// Number of the vertex on the edge between two corners of the cell.
    std::int32_t crossing(int p, int q)
    {
        const int low = std::min(p, q);
        const int high = std::max(p, q);
        const std::int64_t base = cell_ + offset_[low];
        const std::int64_t in_layer = base % (grid_.size[0] * grid_.size[1]);
        std::int32_t& vertex = open_[low >> 2 & 1][in_layer * 7 + (high - low) - 1];
        if (vertex < 0)
        {
            vertex = static_cast<std::int32_t>(surface_.vertices.size());
            const std::int64_t end = cell_ + offset_[high];
            const auto f = static_cast<double>(values_[base]);
            const auto g = static_cast<double>(values_[end]);
            const double share = (static_cast<double>(level_) - f) / (g - f);
            const double t = std::clamp(share, clearance_, 1.0 - clearance_);
            surface_.vertices.push_back((1.0 - t) * grid_.position(base) + t * grid_.position(end));
        }
        return vertex;
    }

    void add(std::int32_t a, std::int32_t b, std::int32_t c)
    {
        surface_.triangles.push_back(mirrored_ ? Triangle{a, c, b} : Triangle{a, b, c});
    }

    /// Split along its shorter diagonal.
    void add_quadrilateral(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d)
    {
        const auto& v = surface_.vertices;
        if (squared_norm(v[a] - v[c]) <= squared_norm(v[b] - v[d]))
        {
            add(a, b, c);
            add(a, c, d);
        }
        else
        {
            add(a, b, d);
            add(b, c, d);
        }
    }

    const VoxelGrid& grid_;
    std::span<const float> values_;
    float level_;
    double clearance_;
    bool mirrored_;
    std::array<std::int64_t, 8> offset_{};
    std::array<std::vector<std::int32_t>, 2> open_; ///< vertices by lower end and direction, of this layer and the next
    std::int64_t cell_ = 0;
    TriangleMesh surface_;
};

} // namespace

TriangleMesh marching_tetrahedra(const VoxelGrid& grid, std::span<const float> values, float level, double clearance)
{
    require_voxels(grid, "values", values.size());
    return Extraction(grid, values, level, clearance).run();
}

} // namespace corticle::imaging

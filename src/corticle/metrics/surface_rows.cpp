// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/metrics/surface_rows.hpp"

#include "corticle/metrics/measure_table.hpp"
#include "corticle/metrics/surface_measures.hpp"

namespace corticle::metrics
{

std::vector<SurfaceRow> surface_rows(std::span<const Vec3> vertices, std::span<const Triangle> triangles,
                                     const FoldOptions& options)
{
    const SurfaceMeasures size = measure_surface(vertices, triangles);
    const FoldMeasures folds = measure_folds(vertices, triangles, fold_fields(vertices, triangles, options), options);
    std::vector<SurfaceRow> rows;
    for (const SizeColumn& column : size_columns())
    {
        rows.push_back({std::string(column.key), std::string(column.unit), size.*column.value});
    }
    for (const FoldColumn& column : fold_columns())
    {
        rows.push_back({std::string(column.key), std::string(column.unit), folds.*column.value});
    }
    return rows;
}

} // namespace corticle::metrics

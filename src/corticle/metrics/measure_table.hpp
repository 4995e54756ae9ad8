// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/metrics/measures.hpp"

#include <string>
#include <string_view>

// The one table of measures: columns of measures.csv, keys of summary.json and of `corticle measure`, and the reference
// of the guide (`corticle schema --measures`) follow from it.

namespace corticle::metrics
{

/// A measure as files name it.
template <class Row>
struct Column
{
    std::string_view key;
    std::string_view unit;     ///< "-": a pure number
    std::string_view sentence; ///< what it is
    double Row::*value;
};
using SizeColumn = Column<SurfaceMeasures>;
using FoldColumn = Column<FoldMeasures>;

/// Those of any closed surface.
std::span<const SizeColumn> size_columns();
std::span<const FoldColumn> fold_columns();

/// A measure of a run: a member of Measures, or one that was added.
class MeasureColumn
{
  public:
    std::string_view key;
    std::string_view unit;
    std::string_view sentence;

    template <class Row>
    constexpr MeasureColumn(const Column<Row>& column) // NOLINT(google-explicit-constructor): so that tables join
        : key(column.key), unit(column.unit), sentence(column.sentence), member_(column.value)
    {
    }
    MeasureColumn(std::string_view its_key, std::string_view its_unit, std::string_view its_sentence, std::size_t place)
        : key(its_key), unit(its_unit), sentence(its_sentence), place_(place)
    {
    }

    /// NaN where the row is older than the measure.
    double of(const Measures& row) const;
    double& in(Measures& row) const;

  private:
    double Measures::*member_ = nullptr;
    std::size_t place_ = 0; ///< in Measures::added
};

/// All measures of a run, in the order of measures.csv.
std::span<const MeasureColumn> measure_columns();

/// Adds a measure of runs to the table, behind all others; before the first run of the process. The texts must stay.
/// @param value  of a run at an output time, in the unit
void add_measure(std::string_view key, std::string_view unit, std::string_view sentence,
                 double (*value)(const model::OutputView& view));

/// Values of the added measures.
std::vector<double> added_measures(const model::OutputView& view);

/// The table as Markdown: key, unit, sentence.
std::string measures_markdown();

} // namespace corticle::metrics

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "corticle/prepare/options.hpp"
#include "corticle/record/run_request.hpp"
#include "corticle/report/report.hpp"
#include "corticle/study/comparison/comparison.hpp"
#include "corticle/study/export.hpp"
#include "corticle/study/fit/fit.hpp"
#include "corticle/study/preparation_folder.hpp"
#include "corticle/study/regions/regional_growth.hpp"
#include "corticle/study/sensitivity/sensitivity.hpp"
#include "corticle/study/sweep/sweep.hpp"
#include "corticle/view/figures/run_figures.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

// One function per verb; each returns the exit status and throws on bad input or a failed run.

namespace corticle
{

namespace exit_status
{
inline constexpr int done = 0;
inline constexpr int bad_input = 2;
inline constexpr int failed = 3;
inline constexpr int interrupted = 130;
} // namespace exit_status

/// One line on stderr, whatever the message holds. @return the status
int complain(std::string message, int status);

struct RunArguments
{
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    record::RunRequest request; ///< without options; out empty: runs/<stem of the case>; body: also its folder
};
int run_command(RunArguments arguments);

struct SweepArguments
{
    sweep::SweepRequest request; ///< out empty: runs/<stem of the sweep>
    bool report = true;          ///< also write report.html
};
int sweep_command(SweepArguments arguments);

/// Without a folder: runs/<stem of the fit>.
int fit_command(fit::FitRequest request);
int sensitivity_command(sensitivity::SensitivityRequest request);

/// Without a folder: runs/<stem of the case>_regions.
int regions_command(regions::RegionsRequest request);

struct PrepareArguments
{
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    study::PrepareRequest request; ///< without options; out empty: prepared/<stem of the case>
    bool quiet = false;
};
int prepare_command(PrepareArguments arguments);

struct NewArguments
{
    std::string what; ///< "brain", or the case to write
    prepare::Shape shape = prepare::Shape::sphere;
};
int new_command(const NewArguments& arguments);

struct CheckArguments
{
    std::filesystem::path case_file;
    std::vector<std::string> overrides;
    int threads = 0; ///< 0: all cores
};
int check_command(const CheckArguments& arguments);

struct SchemaArguments
{
    bool markdown = false;
    bool measures = false;
};
int schema_command(const SchemaArguments& arguments);

/// Where `corticle measure` takes its triangles from.
enum class MeasuredSurface
{
    triangles, ///< the file
    delaunay   ///< made from its points
};

struct MeasureArguments
{
    std::filesystem::path file;
    study::RealSurfaceOptions options;
    metrics::OuterSurface outer = metrics::OuterSurface::hull;
    MeasuredSurface surface = MeasuredSurface::triangles;
    std::optional<double> length_limit_mm;
    std::filesystem::path out;
    std::filesystem::path regions; ///< label volume; empty: no areas of regions
    std::filesystem::path areas;   ///< CSV to write them to
    bool overwrite = false;
    bool json = false;
};
int measure_command(const MeasureArguments& arguments);

struct CompareArguments
{
    study::ComparisonRequest request;
    bool json = false;
    bool report = true; ///< also write report.html
};
int compare_command(const CompareArguments& arguments);

/// With nothing asked for but the folder: the usual pictures again.
int render_command(const view::FigureRequest& request);

int report_command(const report::ReportRequest& request);

/// report.html of results that are done whether or not they can be shown: what keeps it away is a warning. Says whether
/// it was written.
bool write_report_beside(const std::filesystem::path& folder, bool is_quiet);

int export_command(const study::ExportRequest& request);

template <>
inline std::vector<std::string> config::names<MeasuredSurface>()
{
    return {"triangles", "delaunay"};
}

} // namespace corticle

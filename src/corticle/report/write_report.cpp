// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/base/error.hpp"
#include "corticle/formats/atomic_file.hpp"
#include "corticle/record/result_folder.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/report/comparison_report.hpp"
#include "corticle/report/report.hpp"
#include "corticle/report/run_report.hpp"
#include "corticle/report/sweep_report.hpp"

#include <fmt/format.h>

#include <array>

namespace corticle::report
{

namespace
{

/// What a folder holds, and how its page is made.
struct Kind
{
    const char* name;
    bool (*is)(const std::filesystem::path& folder);
    Page (*page)(const ReportRequest& request);
};

constexpr std::array kinds{
    Kind{"run", record::is_run_folder, run_page},
    Kind{"comparison", is_comparison, comparison_page},
    Kind{"sweep", is_sweep, sweep_page},
};

const Kind& kind_of(const std::filesystem::path& folder)
{
    for (const Kind& kind : kinds)
    {
        if (kind.is(folder))
        {
            return kind;
        }
    }
    std::error_code error;
    throw InputError(fmt::format("{}: {}; expected the folder of a run, a comparison or a sweep", folder.string(),
                                 std::filesystem::exists(folder, error) ? "none of these" : "no such folder"));
}

Page page_of(const Kind& kind, const ReportRequest& request)
{
    try
    {
        return kind.page(request);
    }
    catch (const Json::exception& error)
    {
        throw InputError(fmt::format("{}: its JSON is not what corticle writes for a {} ({})", request.folder.string(),
                                     kind.name, error.what()));
    }
}

} // namespace

std::filesystem::path write_report(const ReportRequest& request)
{
    const Kind& kind = kind_of(request.folder);
    const ThreeJs three = read_three_js();
    const std::string text = html(page_of(kind, request), three);
    record::ResultFolder folder(request.folder, kind.name, "");
    folder.claim(std::array{std::string(report_file)});
    formats::write_text_atomically(request.folder / report_file, text);
    return request.folder / report_file;
}

} // namespace corticle::report

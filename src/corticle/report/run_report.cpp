// SPDX-License-Identifier: GPL-3.0-or-later
#include "corticle/report/run_report.hpp"

#include "corticle/record/run_files.hpp"
#include "corticle/report/body.hpp"
#include "corticle/report/plain_text.hpp"
#include "corticle/report/run_facts.hpp"

#include <fmt/format.h>

namespace corticle::report
{

namespace
{

/// Pictures of the last output time, for browsers without WebGL.
Json pictures_json(const record::RunContents& run)
{
    const std::string name = run.frames.back().name();
    Json pictures = Json::array();
    for (const auto& [file, caption] : {std::pair{record::surface_picture("sulcal_depth", name), "Sulcal depth"},
                                        std::pair{record::cut_picture(name), "Section"}})
    {
        if (const std::string source = image_source(run.folder / file); !source.empty())
        {
            pictures.push_back({{"source", source}, {"caption", caption}});
        }
    }
    return pictures;
}

std::string abstract_of(const std::string& name, const Json& summary)
{
    const Json gi = summary.value("gi_hull", Json(nullptr));
    return fmt::format("{}: a simulation of cortical folding with Corticle, {} particles, growth time {:.3g}{}.", name,
                       summary.value("particles", 0), summary.value("t", 0.0),
                       gi.is_number() ? fmt::format(", gyrification index {:.3g}", gi.get<double>()) : "");
}

} // namespace

Page run_page(const ReportRequest& request)
{
    const record::RunContents run = record::read_run(request.folder);
    const std::string name = name_of(request.folder);
    const Json summary = read_summary(request.folder);
    Page page{name, abstract_of(name, summary), {}, {}};
    std::vector<std::string> notes;
    page.content["kind"] = "run";
    page.content["title"] = name;
    page.content["pictures"] = pictures_json(run);
    page.content["maps"] = color_maps_json();
    page.content["scalars"] = scalars_json();
    page.content["measures"] = measures_json(run.measures);
    page.content["facts"] = facts_json(request.folder, summary);
    const std::size_t most = static_cast<std::size_t>(1e6 * request.megabytes);
    const std::size_t rest = page.content.dump(-1, ' ', false, Json::error_handler_t::replace).size() + 1'100'000;
    page.content["bodies"] = pack_bodies({read_body(run, name)}, most > rest ? most - rest : 0, page.blobs, notes);
    page.content["notes"] = notes;
    return page;
}

} // namespace corticle::report

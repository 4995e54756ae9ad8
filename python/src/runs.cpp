// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.hpp"
#include "corticle/config/case_file.hpp"
#include "corticle/config/case_inputs.hpp"
#include "corticle/formats/vtk_files.hpp"
#include "corticle/metrics/measure_table.hpp"
#include "corticle/record/run_reader.hpp"
#include "corticle/report/report.hpp"
#include "corticle/study/comparison/comparison.hpp"
#include "corticle/study/export.hpp"
#include "corticle/study/run_folder.hpp"
#include "corticle/view/run_pictures.hpp"
#include "gate.hpp"
#include "module.hpp"

#include <pybind11/stl.h>

namespace corticle::python
{

namespace
{

/// What of a run is Python's: warnings, outputs, Ctrl-C. What Python raises interrupts the run, whose checkpoint and
/// summary are still written, and is raised again when it has ended.
class PythonHost final : public model::Observer
{
  public:
    PythonHost(py::object warn, py::object on_output, const py::object& tell)
        : warn_(std::move(warn)), on_output_(std::move(on_output)), poll_(tell)
    {
    }

    study::RunHost host()
    {
        study::RunHost host;
        host.stop = [this] { return raised_.has_value(); };
        host.warn = [this](const std::string& line) { with_python([&] { warn_(line); }); };
        host.observers = {this};
        host.draws = false; // needs a display, hence environment variables
        return host;
    }
    void on_step(const model::Simulation& simulation) override
    {
        keep_what_is_raised([&] { poll_(simulation.state().t, simulation.state().steps); });
    }
    void on_output(const model::OutputView& view) override
    {
        with_python(
            [&]
            {
                if (!on_output_.is_none())
                {
                    on_output_(output_of(view));
                }
            });
    }
    /// Call with the GIL.
    void raise_again() const
    {
        if (raised_)
        {
            throw py::error_already_set(*raised_);
        }
    }

  private:
    static py::dict output_of(const model::OutputView& view)
    {
        py::dict output;
        output["number"] = view.number;
        output["t"] = view.state().t;
        output["week"] = view.scale.week;
        output["steps"] = view.state().steps;
        output["vertices"] = array_of(std::vector<Vec3>(view.surface));
        const auto triangles = view.triangles();
        output["triangles"] = array_of(std::vector<Triangle>(triangles.begin(), triangles.end()));
        return output;
    }
    template <class Call>
    void keep_what_is_raised(Call call)
    {
        try
        {
            call();
        }
        catch (const py::error_already_set& error)
        {
            const py::gil_scoped_acquire locked;
            raised_ = raised_ ? raised_ : std::optional(error);
        }
    }
    template <class Call>
    void with_python(Call call)
    {
        const py::gil_scoped_acquire locked;
        keep_what_is_raised(call);
    }

    py::object warn_;
    py::object on_output_;
    Poll poll_;
    std::optional<py::error_already_set> raised_;
};

struct RunPlan
{
    std::string out;
    std::string body;
    bool resume;
    bool overwrite;
};

std::string run(const ResolvedCase& resolved, const RunPlan& plan, const py::object& warn, const py::object& on_output,
                const py::object& tell)
{
    PythonHost watcher(warn, on_output, tell);
    const study::RunHost host = watcher.host();
    model::RunStatus status{};
    {
        const Work work;
        record::RunRequest request;
        request.options = resolved.options;
        config::identify_inputs(request.options);
        request.out = plan.out;
        request.body = plan.body;
        request.resume = plan.resume;
        request.overwrite = plan.overwrite;
        request.quiet = true;
        status = study::simulate(request, host);
    }
    watcher.raise_again();
    return status == model::RunStatus::completed ? "completed" : "interrupted";
}

py::dict read_run(const std::string& folder)
{
    const record::RunContents contents = record::read_run(folder);
    py::list frames;
    for (const record::FrameFiles& frame : contents.frames)
    {
        frames.append(py::make_tuple(frame.t, frame.surface.string(), frame.particles.string()));
    }
    py::dict measures;
    py::dict units;
    for (const formats::NumberColumn& column : contents.measures.columns)
    {
        measures[py::str(column.key)] = array_of(std::vector<double>(column.values));
        units[py::str(column.key)] = column.unit;
    }
    py::dict run;
    run["frames"] = frames;
    run["measures"] = measures;
    run["units"] = units;
    return run;
}

/// Arrays by name: (n,), or (n, components).
py::dict fields_of(std::vector<std::pair<std::string, std::vector<double>>> fields, std::size_t points)
{
    py::dict arrays;
    for (auto& [name, values] : fields)
    {
        const std::size_t components = points == 0 ? 1 : values.size() / points;
        const py::array flat = array_of(std::move(values));
        arrays[py::str(name)] =
            components == 1 ? py::object(flat) : py::object(flat.attr("reshape")(points, components));
    }
    return arrays;
}

py::tuple read_surface_file(const std::string& file)
{
    formats::SurfaceFile read = formats::read_surface_vtp(file);
    const std::size_t points = read.mesh.vertices.size();
    return py::make_tuple(array_of(std::move(read.mesh.vertices)), array_of(std::move(read.mesh.triangles)),
                          fields_of(std::move(read.fields), points));
}

py::tuple read_particle_file(const std::string& file)
{
    formats::ParticleFile read = formats::read_particles_vtu(file);
    const std::size_t points = read.points.size();
    return py::make_tuple(array_of(std::move(read.points)), fields_of(std::move(read.fields), points));
}

study::ComparisonOutcome compare(const std::string& folder, const std::vector<std::string>& others,
                                 const std::string& out, bool overwrite)
{
    const Work work;
    study::ComparisonRequest request;
    request.run = folder;
    request.others = others;
    request.out = out;
    request.overwrite = overwrite;
    return study::compare(request);
}

py::list table_of_measures()
{
    py::list rows;
    for (const metrics::MeasureColumn& column : metrics::measure_columns())
    {
        rows.append(py::make_tuple(std::string(column.key), std::string(column.unit), std::string(column.sentence)));
    }
    return rows;
}

} // namespace

void bind_runs(py::module_& module)
{
    module.def(
        "run",
        [](const ResolvedCase& resolved, const std::string& out, const std::string& body, bool resume, bool overwrite,
           const py::object& warn, const py::object& on_output, const py::object& tell) {
            return run(resolved, {out, body, resume, overwrite}, warn, on_output, tell);
        },
        py::arg("case"), py::arg("out"), py::arg("body"), py::arg("resume"), py::arg("overwrite"), py::arg("warn"),
        py::arg("on_output"), py::arg("tell"));
    module.def("read_run", &read_run, py::arg("folder"));
    module.def("read_surface_file", &read_surface_file, py::arg("file"));
    module.def("read_particle_file", &read_particle_file, py::arg("file"));
    module.def(
        "render", [](const std::string& folder) { view::render_run(folder); }, py::arg("folder"));
    module.def(
        "report",
        [](const std::string& folder, double max_mb) {
            return report::write_report({std::filesystem::absolute(folder), max_mb}).string();
        },
        py::arg("folder"), py::arg("max_mb"));
    module.def(
        "compare",
        [](const std::string& folder, const std::vector<std::string>& others, const std::string& out, bool overwrite)
        {
            const study::ComparisonOutcome outcome = compare(folder, others, out, overwrite);
            return py::make_tuple(outcome.folder.string(), outcome.json, outcome.summary, outcome.warnings);
        },
        py::arg("run"), py::arg("others"), py::arg("out"), py::arg("overwrite"));
    module.def("measures", &table_of_measures);
}

} // namespace corticle::python

#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The same sphere by particles and by finite elements, each at several resolutions: do they tend to the same?

(a) the standard sphere, cases/sphere.toml; (b) a smooth layer and one bulk modulus, as a finite-element code of the
Tallinen lineage ran it. Runs are made with $CORTICLE into --runs (a_sph_20000, a_fem_50000, b_..., one folder each);
those that are complete are kept, one that was stopped goes on. --limit bounds each run: what it has then is kept too.
"""

import argparse
import os
import shutil
import signal
import subprocess
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _plot  # noqa: E402
import _runs  # noqa: E402
import _sphere  # noqa: E402
import reference  # noqa: E402
import verdicts  # noqa: E402

SIZES = {
    "all": {"sph": (20000, 45000, 120000, 250000), "fem": (50000, 100000, 223000, 500000)},
    "small": {"sph": (20000, 45000), "fem": (50000, 100000)},
    "tiny": {"sph": (3000, 6000), "fem": (8000, 16000)},
}
EXTRA = {("a", "fem"): (1500000,), ("b", "fem"): (253000, 1500000)}  # as many nodes as the most particles; the lineage's
SLOW = {("a", "sph"): (250000,), ("a", "fem"): (2600000, 3200000)}  # loaded four times more slowly until they have folded
SLOW_LOADING = ["solver.loading_time=200", "solver.slowest_loading=1", "solver.fastest_loading=10"]
SMOOTH = ["tissue.layer=smooth", "tissue.lambda=0", "tissue.thickness_mm=1.674", "tissue.bulk=uniform",
          "tissue.bulk_modulus=5", "tissue.mu_cortex=1", "tissue.mu_white=1.167"]
CASES = {"a": ("binary layer, K per tissue", []), "b": ("smooth layer, K uniform", SMOOTH)}
KEYS = {"sph": "geometry.particles", "fem": "solver.elements"}
NAMES = {"sph": "TL-SPH", "fem": "FEM"}
SHOWN = (0.5, 1.0)
STORED = ("area_mm2", "volume_mm3", "area_ratio", "volume_ratio", "gi_hull", "gi_sphere", "J_min", "J_mean", "J_max")


def output_times():
    return sorted({round(0.05 * k, 2) for k in range(1, 21)} | {row[0] for row in reference.LINEAGE})


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    default = _runs.ROOT / "build/release/bin/corticle"
    parser.add_argument("--command", type=Path, default=os.environ.get("CORTICLE", default))
    parser.add_argument("--runs", type=Path, help="folder of the runs",
                        default=os.environ.get("CORTICLE_OUT", _runs.ROOT / "runs/validation/sphere_sph_vs_fem"))
    parser.add_argument("--sizes", choices=SIZES, default="all")
    parser.add_argument("--limit", type=float, default=7200.0, help="longest wall time of a run in this session [s]")
    parser.add_argument("--only-read", action="store_true", help="make no runs")
    parser.add_argument("--results", type=Path, default=HERE, help="where results.md and pictures go")
    return parser.parse_args()


def make(arguments, folder, settings):
    """Makes the run or goes on with it; an interrupt at the limit leaves a checkpoint."""
    words = [str(Path(arguments.command).resolve()), "run", str(_runs.ROOT / "cases/sphere.toml"), "--out", str(folder),
             "--resume", *(word for setting in settings for word in ("--set", setting))]
    print(" ".join(words), flush=True)
    process = subprocess.Popen(words)
    try:
        process.wait(timeout=arguments.limit)
    except subprocess.TimeoutExpired:
        print(f"{folder}: stopped at the limit; the next session goes on with it", flush=True)
        process.send_signal(signal.SIGINT)
        process.wait()


def runs_of(arguments, case, method):
    """(size, whether it is loaded slowly) of every run."""
    every = arguments.sizes == "all"
    extra = EXTRA.get((case, method), ()) if every else ()
    sizes = sorted({*SIZES[arguments.sizes][method], *extra})
    slow = SLOW.get((case, method), ()) if every else ()
    return [(size, False) for size in sizes] + [(size, True) for size in slow]


def folder_of(arguments, case, method, size, slow):
    return arguments.runs / f"{case}_{'slow_' if slow else ''}{method}_{size}"


def describe(folder, case, method, size, slow):
    summary, rows = _runs.read_summary(folder), _runs.read_measures(folder)
    result = {key: summary[key] for key in ("version", "particles", "elements", "spacing_mm", "threads", "steps",
                                            "rejected_steps", "zero_mode_share", "wall_s", "onset_t")}
    result |= {"case": case, "method": method, "size": size, "slow": slow,
               "name": f"{NAMES[method]} {size:,}{' slowly' if slow else ''}",
               "ns_per_element_step": summary.get("ns_per_element_step"), "rows": rows,
               "most_overlap": max(row["overlap_area_share"] for row in rows),
               "most_inverted": max(row["inverted_elements"] for row in rows),
               "most_extrapolated": max(row["extrapolated_elements"] for row in rows),
               "folds": {str(t): _sphere.fold_width(folder, t) for t in SHOWN}}
    return result


def at(result, t):
    """Measures at t, linearly between output times."""
    rows = result["rows"]
    after = next((k for k, row in enumerate(rows) if row["t"] >= t - 1e-9), len(rows) - 1)
    before = max(after - 1, 0)
    span = rows[after]["t"] - rows[before]["t"]
    share = min(max((t - rows[before]["t"]) / span, 0.0), 1.0) if span > 0 else 1.0
    return {key: rows[before][key] + share * (rows[after][key] - rows[before][key]) for key in rows[after]}


def results_of(arguments):
    for case, (_, tissue) in CASES.items():
        for method in ("sph", "fem"):
            for size, slow in runs_of(arguments, case, method):
                folder = folder_of(arguments, case, method, size, slow)
                if not arguments.only_read and not _runs.is_complete(folder):
                    times = ", ".join(str(t) for t in output_times())
                    make(arguments, folder, [f"solver.method={'tlsph' if method == 'sph' else 'fem'}",
                                             f"{KEYS[method]}={size}", *tissue, *(SLOW_LOADING if slow else []),
                                             f"output.times=[{times}]",
                                             "output.picture_times=[0.5, 1.0]"])
                if _runs.is_complete(folder):
                    yield describe(folder, case, method, size, slow)
                else:
                    print(f"{folder}: no complete run, left out")


def convergence_table(results):
    columns = [("run", lambda r: r["name"], ""), ("nodes", lambda r: r["particles"], ",d"),
               ("tets", lambda r: r["elements"] or None, ",d"), ("spacing mm", lambda r: r["spacing_mm"], ".3f"),
               ("onset t", lambda r: r["onset_t"], ".4f")]
    for t in SHOWN:
        columns += [(f"{heading} t = {t}", lambda r, t=t, key=key: at(r, t)[key], ".3f")
                    for heading, key in (("area ratio", "area_ratio"), ("volume ratio", "volume_ratio"),
                                         ("hull index", "gi_hull"), ("sphere index", "gi_sphere"))]
        columns += [(f"degree t = {t}", lambda r, t=t: r["folds"][str(t)]["dominant_degree"], "d"),
                    ("wavelength mm", lambda r, t=t: r["folds"][str(t)]["mean_wavelength_mm"], ".2f")]
    return _runs.table(columns, results)


def control_table(results):
    columns = [("run", lambda r: r["name"], ""), ("most overlap", lambda r: r["most_overlap"], ".1e"),
               ("inverted tets", lambda r: r["most_inverted"], ".0f"),
               ("extrapolated tets", lambda r: r["most_extrapolated"], ".0f"),
               ("zero-mode share", lambda r: r["zero_mode_share"], ".3f"), ("steps", lambda r: r["steps"], ",d"),
               ("rejected", lambda r: r["rejected_steps"], "d"), ("wall s", lambda r: r["wall_s"], ".0f"),
               ("ns a tet and step", lambda r: r["ns_per_element_step"], ".1f"), ("threads", lambda r: r["threads"], "d")]
    return _runs.table(columns, results)


def lineage_table(results):
    """Beside the two columns of the Tallinen-lineage run, at its growth times."""
    lines = ["| growth | run | area mm2 | volume mm3 | area / hull |", "| ---: | --- | ---: | ---: | ---: |"]
    for tau, coarse, fine in reference.LINEAGE:
        for name, values in (("lineage, 100,265 tets", coarse), ("lineage, 253,137 tets", fine)):
            lines.append("| {:.3f} | {} | {:,.0f} | {:,.0f} | {:.3f} |".format(tau, name, *values))
        for result in results:
            m = at(result, tau)
            lines.append(f"| {tau:.3f} | {result['name']} | {m['area_mm2']:,.0f} | {m['volume_mm3']:,.0f} | {m['gi_hull']:.3f} |")
    return "\n".join(lines) + "\n"


def table_6(results):
    """Thesis Table 6 with the finest runs of ours beside it."""
    lines = ["| | area mm2 | volume mm3 | area / volume 1/mm | index (area / hull) | reached t |",
             "| --- | ---: | ---: | ---: | ---: | ---: |"]
    lines += ["| {} | {:,.2f} | {:,.2f} | {:.2f} | {:.2f} | {} |".format(*row) for row in reference.TABLE_6]
    for result in results:
        m = at(result, 1.0)
        lines.append(f"| ours, ({result['case']}), {result['name']} | {m['area_mm2']:,.2f} | {m['volume_mm3']:,.2f} | "
                     f"{m['area_mm2'] / m['volume_mm3']:.2f} | {m['gi_hull']:.2f} | 1 |")
    return "\n".join(lines) + "\n"


def finest(results, case, method):
    """Of those loaded slowly, where there are such of both methods."""
    runs = [r for r in results if r["case"] == case]
    slow = {r["method"] for r in runs if r["slow"]} == set(NAMES)
    return max((r for r in runs if r["method"] == method and r["slow"] == slow), key=lambda r: r["size"], default=None)


COARSER = 1.2               # than the finest: a line needs two points apart


def limit_table(results, case):
    """The line through the finest run of each method and the next that is clearly coarser, at spacing 0: what both tend to."""
    lines = []
    for t in SHOWN:
        for heading, key in (("area ratio", "area_ratio"), ("volume ratio", "volume_ratio"), ("sphere index", "gi_sphere")):
            limits = {}
            for method in ("sph", "fem"):
                runs = sorted((r for r in results if (r["case"], r["method"], r["slow"]) == (case, method, False)),
                              key=lambda r: r["spacing_mm"])
                runs = runs[:1] + [r for r in runs if r["spacing_mm"] > COARSER * runs[0]["spacing_mm"]][:1]
                if len(runs) == 2:
                    (h1, v1), (h2, v2) = ((r["spacing_mm"], at(r, t)[key]) for r in runs)
                    limits[method] = v1 + (v1 - v2) / (h2 - h1) * h1
            if len(limits) == 2:
                lines.append((f"{heading}, t = {t}", limits["sph"], limits["fem"], 100 * (limits["sph"] / limits["fem"] - 1)))
    return _runs.table([("", lambda line: line[0], "s"), ("TL-SPH", lambda line: line[1], ".3f"), ("FEM", lambda line: line[2], ".3f"),
                        ("TL-SPH over FEM, %", lambda line: line[3], "+.1f")], lines)


def plots(results, case, path):
    chosen = [r for r in results if r["case"] == case and not r["slow"]]
    panels = []
    for title, key in (("area ratio", "area_ratio"), ("volume ratio", "volume_ratio"), ("sphere index", "gi_sphere"),
                       ("hull index", "gi_hull")):
        panels.append((title, "t", [(r["name"], [row["t"] for row in r["rows"]], [row[key] for row in r["rows"]], "line")
                                    for r in chosen]))
    for t in SHOWN:
        curves = []
        for method in ("sph", "fem"):
            runs = [r for r in chosen if r["method"] == method]
            curves.append((NAMES[method], [r["spacing_mm"] for r in runs], [at(r, t)["area_ratio"] for r in runs], "points"))
        panels.append((f"area ratio at t = {t} against spacing", "spacing mm", [c for c in curves if c[1]]))
    _plot.write(path, panels)


def pictures(arguments, results):
    """corticle compare of the finest runs of each method."""
    for case in CASES:
        sph, fem = (finest(results, case, method) for method in ("sph", "fem"))
        if not sph or not fem:
            continue
        out = arguments.runs / f"compare_{case}"
        folders = [folder_of(arguments, case, r["method"], r["size"], r["slow"]) for r in (sph, fem)]
        shutil.rmtree(out, ignore_errors=True)
        done = subprocess.run([str(Path(arguments.command).resolve()), "compare", *map(str, folders), "--out", str(out),
                               "--time", "0.5", "--time", "1"], check=False, stdout=subprocess.DEVNULL).returncode == 0
        for picture in sorted(out.glob("*.png")) if done else ():
            target = arguments.results / "pictures" / f"{case}_{picture.name}"
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(picture, target)
        yield case, done


def main():
    arguments = parse_arguments()
    results = list(results_of(arguments))
    if not results:
        sys.exit("no complete run")
    found = list(verdicts.all_of(results, at, finest))
    sections = [("Verdicts", verdicts.table(found))]
    for case, (name, _) in CASES.items():
        chosen = [r for r in results if r["case"] == case]
        if chosen:
            sections += [(f"({case}) {name}: what is measured", convergence_table(chosen)),
                         (f"({case}) {name}: the line through the finest and the next clearly coarser, at spacing 0", limit_table(results, case)),
                         (f"({case}) {name}: controls and cost", control_table(chosen))]
            plots(results, case, arguments.results / f"convergence_{case}.svg")
            sections.append((f"({case}) {name}: curves", f"![](convergence_{case}.svg)\n"))
    sections.append(("(b) beside a code of the Tallinen lineage", lineage_table([r for r in results if r["case"] == "b"])))
    best = [r for r in (finest(results, case, method) for case in CASES for method in ("sph", "fem")) if r]
    sections.append(("Thesis Table 6", table_6(best)))
    for case, done in pictures(arguments, results):
        if done:
            names = sorted((arguments.results / "pictures").glob(f"{case}_*.png"))
            sections.append((f"({case}) finest of each, side by side (TL-SPH left)",
                             "\n\n".join(f"![](pictures/{name.name})" for name in names) + "\n"))
    stored = [{key: value for key, value in r.items() if key != "rows"} | {"at": {str(t): {key: at(r, t)[key] for key in STORED} for t in SHOWN}}
              for r in results]
    _runs.write_results(arguments.results, "Particles and finite elements on the same sphere", stored, sections)
    _runs.finish(what for verdict, what in found if verdict == "DIFFERS")


main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""White matter that grows as it is stretched: wavelength and depth of folds against the ratio of the rates, on an ellipsoid that can
expand and in a strip that cannot.
"""

import _runs
import _strip

CORTEX_RATES = {"ellipsoid": 1.8284271247461903, "strip": 0.8}  # alpha_t: of the cortex per growth time
RATES = {"ellipsoid": (0.0, 1.0, 3.0, 10.0), "strip": (0.0, 0.4, 1.2, 4.0)}  # G_s per growth time
SEEDS = (1, 2)
CASES = _runs.ROOT / "cases" / "hypotheses"
PARTICLES = 8000       # of the ellipsoid
RATIO, BULK = 3.0, 10.0
LENGTH, DEPTH = 24.0, 7.0
CELLS = 2
MODES = 16
MOST_ERROR = 0.01      # of the energy balance
MOST_SHORTER = 0.05    # of the wavelength, from no growth of the white matter to the fastest
SAME = 0.02            # of the depth: differences below it are none


def plan(body, rate, seed):
    """Case and settings of a run."""
    if body == "ellipsoid":
        settings = {"geometry.particles": PARTICLES, "imperfection.seed": seed, "output.pictures": "off", "output.report": "off"}
        case = CASES / ("stress_growth.toml" if rate else "differential_growth.toml")
    else:
        spacing = 1 / CELLS
        settings = {"geometry.size_mm": f"[{LENGTH}, {4 * spacing:.6f}, {DEPTH}]", "geometry.spacing_mm": spacing,
                    "tissue.mu_cortex": RATIO, "tissue.bulk_modulus": BULK, "tissue.alpha_t": CORTEX_RATES[body],
                    "imperfection.amplitude": 0.05, "imperfection.seed": seed, "output.count": 16}
        case = _strip.CASE
    if rate:
        settings["stress_growth.rate"] = rate
    return case, [f"{key}={value}" for key, value in settings.items()]


def shape(body, folder, row):
    """(wavelength, depth) at the end: of the ellipsoid on its reference surface and below its hull, mm; of the strip from its waves."""
    if body == "ellipsoid":
        return row["fold_wavelength_reference_mm"], row["sulcal_depth_mean_mm"]
    alpha = CORTEX_RATES[body]
    return 2 * LENGTH / _strip.mean_number(folder, alpha, MODES), 2 * _strip.heights(folder, alpha)[-1][1]


def describe(body, rate, folders):
    """Means over the seeds, at the end."""
    rows = [_runs.read_measures(folder)[-1] for folder in folders]
    shapes = [shape(body, folder, row) for folder, row in zip(folders, rows)]

    def mean(values):
        return sum(values) / len(values)

    return {"body": body, "rate": rate, "ratio": rate / CORTEX_RATES[body], "seeds": len(rows),
            "wavelength": mean([wave for wave, _ in shapes]), "depth": mean([depth for _, depth in shapes]), "shapes": shapes,
            "gi_hull": mean([row["gi_hull"] for row in rows]),
            "taken": mean([row["energy_remodelling"] / row["work_growth"] for row in rows]),
            "most_error": max(row["energy_balance_error"] for row in rows),
            "wall_s": mean([_runs.read_summary(folder)["wall_s"] for folder in folders])}


def results_of(arguments, base):
    found = []
    for body, rates in RATES.items():
        for rate in rates:
            complete = []
            for seed in SEEDS:
                folder = base / f"{body}_{rate:g}_s{seed}"
                case, settings = plan(body, rate, seed)
                if _runs.has_run(arguments, case, folder, settings):
                    complete.append(folder)
            if complete:
                found.append(describe(body, rate, complete))
    return found


def table(results):
    columns = [("body", lambda r: r["body"], ""), ("G_s", lambda r: r["rate"], "g"), ("G_s / G_c", lambda r: r["ratio"], ".2f"),
               ("wavelength", lambda r: r["wavelength"], ".2f"), ("depth", lambda r: r["depth"], ".3f"),
               ("hull index", lambda r: r["gi_hull"] if r["body"] == "ellipsoid" else None, ".3f"),
               ("taken by growth, of the work", lambda r: r["taken"], ".4f"), ("seeds", lambda r: r["seeds"], "d"),
               ("most energy balance error", lambda r: r["most_error"], ".1e"), ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    """What does not go as published: depth falls, and wavelength does not, as white matter follows faster."""
    for body in RATES:
        rows = [r for r in results if r["body"] == body]
        for slower, faster in zip(rows, rows[1:]):
            if faster["depth"] > (1 + SAME) * slower["depth"]:
                yield f"white matter, {body}, G_s {slower['rate']:g} to {faster['rate']:g}: folds become deeper"
        if rows and rows[-1]["wavelength"] < (1 - MOST_SHORTER) * rows[0]["wavelength"]:
            yield f"white matter, {body}: the wavelength falls with its rate, expected to rise"
    for result in results:
        if result["most_error"] > MOST_ERROR:
            yield f"white matter, {result['body']}, G_s {result['rate']:g}: energy balance off by {result['most_error']:.4f}"


def panels(results):
    for key, title in (("depth", "Depth of folds, over that without growth"), ("wavelength", "Their wavelength, likewise")):
        curves = []
        for body in RATES:
            rows = [r for r in results if r["body"] == body]
            if rows:
                curves.append((body, [r["ratio"] for r in rows], [r[key] / rows[0][key] for r in rows], "line"))
        yield title, "rate of white matter over that of the cortex", curves

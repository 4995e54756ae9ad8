# SPDX-License-Identifier: GPL-3.0-or-later
"""A tract of springs between two places of a film: how early the film folds, by the stiffness of the springs.

The set-up of X. Wang, S. Wang & Holland (2024) in film thicknesses and shear moduli of the base: a strip of 40 x 20, the tract a
parabola from 6.1 thicknesses beside the middle, just below the film, down to a depth of 3.5; springs half as long at rest as in
the strip. Here one half of it, 18 thicknesses long and 8 deep, with rollers in the plane of symmetry.
"""

import csv
import math

import _layer
import _runs
import _strip

PUBLISHED = {3: (0.0833, 0.0755, 0.0695), 9: (0.0455, 0.0383, 0.0333), 30: (0.0287, 0.0165, 0.0123)}
STIFFNESSES = (10, 150, 300)  # N/m, of springs 0.13 mm long, in a film of 2 mm with a base of 100 Pa

FILM_MM, BASE_PA = 2.0, 100.0
SPRING_MM = 0.13
BEND, DEEPEST = 1 / 30, 7.0   # of the parabola: mm below the surface are 7 - x² / 30
BULK = 9.3 + 2 / 3            # Lame's constant is 9.3 mu
GROWTH_WAVES = {3: 7.8, 9: 10.2, 30: 14.4}
LENGTH, DEPTH = 18.0, 8.0
CELLS = 2
LOADING = 100.0
MODES = 8
SEGMENTS = 12
REACH = 0.5                   # thicknesses: 1 mm
VISIBLE = 0.15                # thicknesses: half of the height from valley to crown at which the film counts as folded
MOST_OFF = 0.10


def parabola():
    """Points of one half of the tract, evenly along it, from the middle to the film: (x, depth) in thicknesses."""
    half_span = math.sqrt((DEEPEST - FILM_MM) / BEND)
    fine = [half_span * k / 4000 for k in range(4001)]
    depths = [DEEPEST - BEND * x * x for x in fine]
    lengths = [0.0]
    for k in range(4000):
        lengths.append(lengths[-1] + math.hypot(fine[k + 1] - fine[k], depths[k + 1] - depths[k]))
    points, k = [], 0
    for n in range(SEGMENTS + 1):
        while k < 4000 and lengths[k] < lengths[-1] * n / SEGMENTS:
            k += 1
        points.append((fine[k] / FILM_MM, depths[k] / FILM_MM))
    return points, lengths[-1] / SEGMENTS


def write_tract(path, stiffness, width):
    """The table of tracts; stiffness in N/m for a strip one metre wide, as a series of springs of SPRING_MM."""
    points, segment_mm = parabola()
    force = stiffness / BASE_PA * width * SPRING_MM / segment_mm
    with open(path, "w", encoding="utf-8", newline="") as stream:
        writer = csv.writer(stream)
        writer.writerow(["from_x", "from_y", "from_z", "to_x", "to_y", "to_z", "stiffness"])
        places = [(x - 0.5 * LENGTH, 0.0, 0.5 * DEPTH - depth) for x, depth in points]
        for start, end in zip(places, places[1:]):
            writer.writerow([f"{value:.6f}" for value in (*start, *end)] + [f"{force:.8f}"])


def plan(base, ratio, stiffness):
    """What a run is, and its settings; stiffness 0: no tract."""
    around = GROWTH_WAVES[ratio]
    growth, wavelength = _layer.critical(_layer.Strip(ratio, BULK, 2 * around), around)
    spacing = 1 / CELLS
    alpha = 1.1 * (growth - 1)
    settings = {"geometry.size_mm": f"[{LENGTH}, {4 * spacing:.6f}, {DEPTH}]", "geometry.spacing_mm": spacing,
                "tissue.mu_cortex": float(ratio), "tissue.bulk_modulus": BULK, "tissue.alpha_t": alpha,
                "tissue.alpha_r": alpha, "solver.loading_time": LOADING, "imperfection.amplitude": 0.0}
    if stiffness:
        table = base / f"tract_{stiffness}.csv"
        base.mkdir(parents=True, exist_ok=True)
        write_tract(table, stiffness, 4 * spacing)
        settings |= {"tracts.file": table.resolve(), "tracts.rest": 0.5, "tracts.ramp_time": 0.1, "tracts.reach_mm": REACH}
    run = {"name": f"springs_{ratio}_{stiffness}", "ratio": ratio, "stiffness": stiffness, "alpha": alpha,
           "theory_strain": _layer.strain(growth), "theory_wavelength": wavelength}
    return run, [f"{key}={value}" for key, value in settings.items()]


def describe(run, folder):
    heights = _strip.heights(folder, run["alpha"])
    growth = _strip.visible_growth(heights, VISIBLE)
    past = _strip.history(folder, run["alpha"], MODES)
    first = _strip.first_mode(_strip.modes_of(past, LENGTH, range(2, MODES + 1)))
    summary = _runs.read_summary(folder)
    published = dict(zip(STIFFNESSES, PUBLISHED[run["ratio"]])).get(run["stiffness"])
    return run | {"strain": _layer.strain(growth) if growth else None, "southwell_strain": _layer.strain(first["growth"]),
                  "published_strain": published, "particles": summary["particles"], "wall_s": summary["wall_s"],
                  "energy_balance_error": summary["energy_balance_error"], "heights": heights}


def results_of(arguments, base):
    found = []
    for ratio in PUBLISHED:
        for stiffness in STIFFNESSES:
            run, settings = plan(base, ratio, stiffness)
            folder = base / run["name"]
            if _runs.has_run(arguments, _strip.CASE, folder, settings):
                found.append(describe(run, folder))
    return found


def fall(results, result, key):
    """Strain over that at the weakest springs of the same ratio."""
    first = next((r for r in results if r["ratio"] == result["ratio"] and r["stiffness"] == STIFFNESSES[0]), None)
    return result[key] / first[key] if first and first[key] and result[key] and result["stiffness"] else None


def table(results):
    columns = [("ratio", lambda r: r["ratio"], "d"), ("stiffness N/m", lambda r: r["stiffness"], "d"),
               ("strain when folds are seen", lambda r: r["strain"], ".4f"), ("published", lambda r: r["published_strain"], ".4f"),
               ("over that at 10 N/m", lambda r: fall(results, r, "strain"), ".3f"),
               ("published ", lambda r: fall(results, r, "published_strain"), ".3f"),
               ("strain by Southwell", lambda r: r["southwell_strain"], ".4f"),
               ("theory without springs", lambda r: r["theory_strain"], ".4f"), ("nodes", lambda r: r["particles"], ",d"),
               ("energy balance error", lambda r: r["energy_balance_error"], ".1e"), ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def differences(results):
    for result in (r for r in results if r["stiffness"]):
        name = f"springs, ratio {result['ratio']}, {result['stiffness']} N/m"
        if not result["strain"]:
            yield f"{name}: no folds are seen, published {result['published_strain']}"
        elif abs(result["strain"] / result["published_strain"] - 1) > MOST_OFF:
            yield f"{name}: strain {result['strain']:.4f}, published {result['published_strain']}"
    for ratio in PUBLISHED:
        strains = [r["strain"] for r in results if r["ratio"] == ratio and r["strain"]]
        if any(later > earlier for earlier, later in zip(strains, strains[1:])):
            yield f"springs, ratio {ratio}: stiffer springs fold the film later"


def panels(results):
    curves = []
    for ratio, published in PUBLISHED.items():
        ours = [r for r in results if r["ratio"] == ratio and r["strain"]]
        curves.append((f"ours, ratio {ratio}", [r["stiffness"] for r in ours], [r["strain"] for r in ours], "line"))
        curves.append((f"published, ratio {ratio}", list(STIFFNESSES), list(published), "points"))
    yield "Strain when the film folds", "stiffness of the springs N/m", curves

# SPDX-License-Identifier: GPL-3.0-or-later
"""Growth at which a film folds under the pressure of a fluid, beside theory and Jafarabadi et al. (2023)."""

import _layer
import _runs
import _strip

# Critical strain by pressure over the shear modulus of the film. The highest published is 4 (0.226, 0.135, 0.073); at 1 the ends of
# our strips collapse before the film folds.
PUBLISHED = {1: {0.0: 0.2628, 0.5: 0.2480}, 3: {0.0: 0.1638, 0.5: 0.1509}, 10: {0.0: 0.0917, 0.5: 0.0830}}
VISIBLE = 0.15   # thicknesses: half of the height from valley to crown at which the film counts as folded
BULK = 100.0
CELLS = 3
DEPTH = 5.0
HALF_WAVES = 3
MODES = 6
OVERSHOOT = 1.2
LOADING = 200.0
DAMPING = 2.0
MOST_OFF = 0.10  # of the strain, from published
WAVES = {1: 6.2, 3: 7.8, 10: 10.4}


def strip(ratio, pressure, depth=DEPTH):
    """In shear moduli of the base; the pressure is given in those of the film."""
    return _layer.Strip(ratio, BULK, depth, pressure * ratio)


def plan(ratio, pressure):
    """What a run is, and its settings: shear moduli and pressure over the modulus of the film."""
    growth, wavelength = _layer.critical(strip(ratio, pressure, 14.0), WAVES[ratio])
    length, spacing = 0.5 * HALF_WAVES * wavelength, 1 / CELLS
    alpha = OVERSHOOT * (growth - 1)
    settings = {"geometry.size_mm": f"[{length:.6f}, {4 * spacing:.6f}, {DEPTH}]", "geometry.spacing_mm": spacing,
                "tissue.mu_cortex": 1.0, "tissue.mu_white": 1 / ratio, "tissue.bulk_modulus": BULK, "tissue.alpha_t": alpha,
                "solver.loading_time": LOADING,
                "solver.damping": DAMPING}
    if pressure:
        settings |= {"boundary.fluid": "constant", "boundary.pressure": pressure, "boundary.pressure_time": 0.3}
    run = {"name": f"pressure_{ratio}_{pressure:g}", "ratio": ratio, "pressure": pressure, "length": length, "alpha": alpha,
           "theory_growth": growth, "theory_wavelength": wavelength}
    return run, [f"{key}={value}" for key, value in settings.items()]


def describe(run, folder):
    past = _strip.history(folder, run["alpha"], MODES)
    modes = _strip.modes_of(past, run["length"], range(1, MODES + 1))
    first = _strip.first_mode(modes)
    seen = _strip.visible_growth(_strip.heights(folder, run["alpha"]), VISIBLE)
    summary = _runs.read_summary(folder)
    return run | {"modes": modes, "growth": first["growth"], "wavelength": first["wavelength"],
                  "strain": _layer.strain(seen) if seen else None,
                  "southwell_strain": _layer.strain(first["growth"]), "theory_strain": _layer.strain(run["theory_growth"]),
                  "published_strain": PUBLISHED[run["ratio"]][run["pressure"]],
                  "energy_balance_error": summary["energy_balance_error"], "particles": summary["particles"],
                  "wall_s": summary["wall_s"]}


def results_of(arguments, base):
    found = []
    for ratio, strains in PUBLISHED.items():
        for pressure in strains:
            run, settings = plan(ratio, pressure)
            folder = base / run["name"]
            if _runs.has_run(arguments, _strip.CASE, folder, settings):
                found.append(describe(run, folder))
    return found


def table(results):
    columns = [("ratio", lambda r: r["ratio"], "d"), ("pressure / film modulus", lambda r: r["pressure"], "g"),
               ("strain when folds are seen", lambda r: r["strain"], ".4f"), ("published", lambda r: r["published_strain"], ".4f"),
               ("strain by Southwell", lambda r: r["southwell_strain"], ".4f"), ("theory, following pressure", lambda r: r["theory_strain"], ".4f"),
               ("nodes", lambda r: r["particles"], ",d"),
               ("energy balance error", lambda r: r["energy_balance_error"], ".1e"), ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def changes(results):
    """(ratio, change of the strain from no pressure to the highest, the same by theory and published)."""
    by_key = {(r["ratio"], r["pressure"]): r for r in results}
    for ratio, strains in PUBLISHED.items():
        pair = [by_key.get((ratio, pressure)) for pressure in strains]
        if all(run and run["strain"] for run in pair):
            yield {"ratio": ratio} | {name: pair[1][key] / pair[0][key] - 1 for name, key in
                                      (("ours", "strain"), ("theory", "theory_strain"), ("published", "published_strain"))}


def changes_table(results):
    columns = [("ratio", lambda r: r["ratio"], "d"), ("ours", lambda r: r["ours"], "+.1%"),
               ("theory", lambda r: r["theory"], "+.1%"), ("published", lambda r: r["published"], "+.1%")]
    return _runs.table(columns, list(changes(results)))


def theory_table(_):
    """Critical strain by linear theory on a deep base, of a fluid and of a load that keeps its force."""
    rows = []
    for ratio in PUBLISHED:
        for pressure in (0.0, 4.0):
            strains = [_layer.strain(_layer.critical(_layer.Strip(ratio, BULK, 14.0, pressure * ratio, False, is_fluid), WAVES[ratio])[0])
                       for is_fluid in (True, False)]
            rows.append({"ratio": ratio, "pressure": pressure, "fluid": strains[0], "kept": strains[1]})
    columns = [("ratio", lambda r: r["ratio"], "d"), ("pressure / film modulus", lambda r: r["pressure"], "g"),
               ("fluid", lambda r: r["fluid"], ".4f"), ("force kept", lambda r: r["kept"], ".4f")]
    return _runs.table(columns, rows)


def differences(results):
    for result in results:
        if not result["strain"]:
            yield f"pressure, ratio {result['ratio']}, {result['pressure']:g}: no folds are seen"
        elif abs(result["strain"] / result["published_strain"] - 1) > MOST_OFF:
            yield (f"pressure, ratio {result['ratio']}, {result['pressure']:g}: strain {result['strain']:.4f}, "
                   f"published {result['published_strain']}")
    for change in changes(results):
        if change["ours"] * change["published"] < 0:
            yield (f"pressure, ratio {change['ratio']}: from the lowest to the highest the strain changes by "
                   f"{change['ours']:+.1%}, published {change['published']:+.1%}")


def panels(results):
    pressures = [0.5 * k for k in range(9)]
    curves = []
    for ratio in PUBLISHED:
        found = [_layer.critical(strip(ratio, pressure, 14.0), WAVES[ratio])[0] for pressure in pressures]
        curves.append((f"theory, ratio {ratio}", pressures, [_layer.strain(growth) for growth in found], "line"))
        ours = [r for r in results if r["ratio"] == ratio and r["strain"]]
        curves.append((f"TL-SPH, ratio {ratio}", [r["pressure"] for r in ours], [r["strain"] for r in ours], "points"))
        curves.append((f"published, ratio {ratio}", list(PUBLISHED[ratio]), list(PUBLISHED[ratio].values()), "points"))
    yield "Critical strain under a fluid", "pressure / shear modulus of the film", curves

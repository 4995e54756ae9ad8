# SPDX-License-Identifier: GPL-3.0-or-later
"""A thin film that grows on a soft base: when it folds, into which wavelength, beside theory and published numbers."""

import math

import _layer
import _runs
import _strip

# Published theory: compression at the onset, wavelength in thicknesses of the film (X. Wang, S. Wang & Holland 2024, after Holland,
# Li, Feng & Kuhl 2017): incompressible, a film that grows alike along both directions of its plane.
PUBLISHED = {1: (0.2362, 6.22), 3: (0.138, 7.83), 10: (0.0688, 10.42)}
DEPTH = 5.0         # thicknesses of film and base
OVERSHOOT = 1.06    # growth of a run over that expected at the onset
DAMPING = 2.0
MODES = 9
MOST_OFF = 0.10     # of the strain, from published and from theory of the same strip
MOST_OFF_WAVE = 0.15

NAMES = {"s": "TL-SPH", "f": "FEM"}
STANDARD = {"cells": 4, "bulk": 20.0, "loading": 400.0, "method": "s", "half_waves": 3}  # half_waves: expected in the length
RUNS = [  # ratio, what is changed
    *((ratio, {}) for ratio in PUBLISHED),
    (1, {"half_waves": 5}),
    *((3, {"loading": loading}) for loading in (100.0, 200.0)),
    *((ratio, {"loading": 200.0}) for ratio in (1, 10)),
    *((3, {"loading": 200.0} | change) for change in ({"cells": 3}, {"bulk": 5.0}, {"method": "f"})),
    (1, {"loading": 200.0, "method": "f"}),
]


def infinite(ratio, bulk):
    """Onset on a deep base: (growth, wavelength)."""
    around = PUBLISHED[ratio][1]
    return _layer.critical(_layer.Strip(ratio, bulk, 2 * around), around)


def plan(ratio, change):
    """What a run is, and its settings."""
    chosen = STANDARD | change
    growth, wavelength = infinite(ratio, chosen["bulk"])
    length = 0.5 * chosen["half_waves"] * wavelength
    spacing = 1 / chosen["cells"]
    width = 3 if chosen["cells"] == 4 else 4  # spacings across the plane
    alpha = OVERSHOOT * (growth - 1)
    settings = {"geometry.size_mm": f"[{length:.6f}, {width * spacing:.6f}, {DEPTH}]", "geometry.spacing_mm": spacing,
                "tissue.mu_cortex": float(ratio), "tissue.bulk_modulus": chosen["bulk"], "tissue.alpha_t": alpha,
                "solver.loading_time": chosen["loading"], "solver.damping": DAMPING}
    if chosen["method"] == "f":
        settings["solver.method"] = "fem"
    name = f"film_{chosen['method']}{ratio}_c{chosen['cells']}_K{chosen['bulk']:g}_L{chosen['loading']:g}_n{chosen['half_waves']}"
    return {"name": name, "ratio": ratio, "length": length, "alpha": alpha, "theory_growth": growth,
            "theory_wavelength": wavelength, **chosen}, [f"{key}={value}" for key, value in settings.items()]


def describe(run, folder):
    past = _strip.history(folder, run["alpha"], MODES)
    strip = _layer.Strip(run["ratio"], run["bulk"], DEPTH)
    modes = [mode | {"theory": _layer.onset(strip, mode["wavelength"]), "largest": max(abs(values[mode["n"] - 1]) for _, values in past)}
             for mode in _strip.modes_of(past, run["length"], range(1, MODES + 1))]
    first = _strip.first_mode(modes)
    summary = _runs.read_summary(folder)
    published_strain, published_wave = PUBLISHED[run["ratio"]]
    return run | {"modes": modes, "growth": first["growth"], "wavelength": first["wavelength"],
                  "strain": _layer.strain(first["growth"]), "theory_strain": _layer.strain(run["theory_growth"]),
                  "published_strain": published_strain, "published_wavelength": published_wave,
                  "kinetic_share": summary["kinetic_share"], "steps": summary["steps"], "particles": summary["particles"],
                  "wall_s": summary["wall_s"], "threads": summary["threads"]}


def results_of(arguments, base):
    found = []
    for ratio, change in RUNS:
        run, settings = plan(ratio, change)
        folder = base / run["name"]
        if _runs.has_run(arguments, _strip.CASE, folder, settings):
            found.append(describe(run, folder))
    return found


def table(results):
    columns = [("method", lambda r: NAMES[r["method"]], ""), ("ratio", lambda r: r["ratio"], "d"),
               ("spacings in the film", lambda r: r["cells"], "d"), ("half-waves", lambda r: r["half_waves"], "d"), ("K / mu", lambda r: r["bulk"], "g"),
               ("loading time", lambda r: r["loading"], "g"), ("strain", lambda r: r["strain"], ".4f"),
               ("theory, this K", lambda r: r["theory_strain"], ".4f"), ("published", lambda r: r["published_strain"], ".4f"),
               ("off published", lambda r: off(r), "+.1%"), ("wavelength", lambda r: r["wavelength"], ".2f"),
               ("theory", lambda r: r["theory_wavelength"], ".2f"), ("published ", lambda r: r["published_wavelength"], ".2f"),
               ("nodes", lambda r: r["particles"], ",d"), ("wall s", lambda r: r["wall_s"], ".0f")]
    return _runs.table(columns, results)


def modes_table(results):
    """Each fold of the standard strips by itself."""
    rows = [mode | {"ratio": result["ratio"], "method": result["method"]} for result in results if is_standard(result)
            for mode in result["modes"] if mode["growth"]]
    columns = [("method", lambda r: NAMES[r["method"]], ""), ("ratio", lambda r: r["ratio"], "d"),
               ("wavelength", lambda r: r["wavelength"], ".2f"), ("growth", lambda r: r["growth"], ".4f"),
               ("theory", lambda r: r["theory"], ".4f"), ("explained by the fit", lambda r: r["explained"], ".5f")]
    return _runs.table(columns, rows)


def off(result):
    return result["strain"] / result["published_strain"] - 1


def is_standard(result):
    return all(result[key] == value for key, value in STANDARD.items())


def differences(results):
    for result in filter(is_standard, results):
        name = f"film, {NAMES[result['method']]}, ratio {result['ratio']}"
        if abs(off(result)) > MOST_OFF:
            yield f"{name}: critical strain {result['strain']:.4f}, published {result['published_strain']}"
        if abs(math.log(result["wavelength"] / result["published_wavelength"])) > MOST_OFF_WAVE:
            yield f"{name}: wavelength {result['wavelength']:.2f}, published {result['published_wavelength']}"


def panels(results):
    ratios = [1 + 0.5 * k for k in range(19)]
    curve = []
    for ratio in ratios:
        around = 6.22 * ratio**0.224
        curve.append(_layer.critical(_layer.Strip(ratio, 1000.0, 2 * around), around))
    standard = list(filter(is_standard, results))

    def of(method, key):
        chosen = [r for r in standard if r["method"] == method]
        return [r["ratio"] for r in chosen], [r[key] for r in chosen]

    yield ("Critical strain of the film", "stiffness ratio", [
        ("theory, incompressible", ratios, [_layer.strain(growth) for growth, _ in curve], "line"),
        ("published", list(PUBLISHED), [strain for strain, _ in PUBLISHED.values()], "points"),
        ("TL-SPH", *of("s", "strain"), "points"), ("FEM", *of("f", "strain"), "points")])
    yield ("Its wavelength, in thicknesses", "stiffness ratio", [
        ("theory, incompressible", ratios, [wavelength for _, wavelength in curve], "line"),
        ("published", list(PUBLISHED), [wavelength for _, wavelength in PUBLISHED.values()], "points"),
        ("TL-SPH", *of("s", "wavelength"), "points"), ("FEM", *of("f", "wavelength"), "points")])

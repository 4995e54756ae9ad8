#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The standard sphere at several resolutions: when it folds, how wide the folds are, and what the measures tend to.

Runs are made with $CORTICLE into $CORTICLE_OUT (s20, s45, ...: thousands of particles), or read with --runs.
"""

import math
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.insert(0, str(HERE.parent))

import _harmonics  # noqa: E402
import _runs  # noqa: E402
import _vtk  # noqa: E402

SIZES = [20000, 45000, 120000, 250000]
SETTINGS = ["output.count=20"]
RADIUS_MM = 12.496
LARGEST_DEGREE = 20
SPECTRUM_T = 0.3         # folds are there, and not yet deep
GROWTH_T = (0.2, 0.25)   # around the first instability, folds of less than 0.2 mm
LEAST_SHARE = 0.02       # of the power, for a degree's growth to be told from noise

# Second variation of the unfolded state: g = 1.441 at t = 0.241, degree 8 or 9 first.
ONSET_T = (0.241, 0.27)  # of the finest run: not before theory; imperfections are small and must first grow
FASTEST_DEGREE = (7, 10) # of the finest run: 8 to 9, and one more or less, for their neighbours grow nearly as fast
MOST_OVERLAP = 0.001


def spectrum(folder, t):
    """Power [mm^2] of the radial displacement by degree at the output time nearest to t, and that time."""
    row, measures = _runs.nearest_row(_runs.read_measures(folder), t)
    points, displacements, triangles = _vtk.read_surface(folder / f"surface_{row:04d}.vtp")
    directions = [tuple(x / math.hypot(*point) for x in point) for point in points]
    radial = [sum(n * u for n, u in zip(direction, displacement))
              for direction, displacement in zip(directions, displacements)]
    areas = _harmonics.vertex_areas(points, triangles)
    return _harmonics.power_by_degree(directions, radial, areas, LARGEST_DEGREE), measures["t"]


def fastest_degree(folder):
    """The degree whose amplitude grows by the largest factor over GROWTH_T, and the factors of all degrees."""
    (before, _), (after, _) = (spectrum(folder, t) for t in GROWTH_T)
    factors = [math.sqrt(b / a) for a, b in zip(before, after)]
    heard = [degree for degree in range(1, len(after)) if after[degree] > LEAST_SHARE * sum(after[1:])]
    return max(heard, key=factors.__getitem__), factors


def fold_width(folder):
    """Degrees of the folds, and their wavelengths on the reference sphere."""
    power, t = spectrum(folder, SPECTRUM_T)
    folds = range(1, len(power)) # degree 0 is growth as a whole
    dominant = max(folds, key=power.__getitem__)
    fastest, factors = fastest_degree(folder)
    return {"t": t, "power_mm2": power, "growth_factors": factors, "dominant_degree": dominant,
            "mean_degree": sum(degree * power[degree] for degree in folds) / sum(power[1:]), "fastest_degree": fastest,
            "dominant_wavelength_mm": _harmonics.wavelength(RADIUS_MM, dominant),
            "fastest_wavelength_mm": _harmonics.wavelength(RADIUS_MM, fastest)}


def fold_table(results):
    def of(key):
        return lambda result: result["folds"][key]

    columns = [("particles", lambda r: r["particles"], ",d"),
               ("fastest-growing degree", of("fastest_degree"), "d"), ("its wavelength mm", of("fastest_wavelength_mm"), ".2f"),
               ("dominant degree at t = 0.3", of("dominant_degree"), "d"),
               ("its wavelength mm", of("dominant_wavelength_mm"), ".2f"), ("mean degree at t = 0.3", of("mean_degree"), ".2f")]
    return _runs.table(columns, results)


def differences(results):
    """What does not agree with theory, or must not happen at any resolution."""
    for result in results:
        yield from _runs.faults(result, MOST_OVERLAP)
    finest = results[-1]
    for what, value, (low, high) in (("onset t", finest["onset_t"], ONSET_T),
                                     ("fastest-growing degree", finest["folds"]["fastest_degree"], FASTEST_DEGREE)):
        if value is None or not low <= value <= high:
            yield f"finest run: {what} is {value}, expected {low} to {high}"


def main():
    arguments = _runs.parse_arguments(__doc__, SIZES)
    case = _runs.ROOT / "cases" / "sphere.toml"
    found = _runs.folders(arguments, case, "s", SETTINGS, _runs.ROOT / "runs/validation/sphere_convergence")
    if not found:
        sys.exit("no complete run")
    results = [_runs.describe(folder) | {"folds": fold_width(folder)} for _, folder in found]
    _runs.write_results(HERE, "The standard sphere at several resolutions", results,
                        [("Onset and controls", _runs.control_table(results)),
                         ("Width of the folds", fold_table(results)),
                         ("Half of the growth", _runs.time_table(results, "half")),
                         ("All of the growth", _runs.time_table(results, "end"))])
    missing = len(arguments.sizes) - len(found) if not arguments.runs else 0
    _runs.finish([*differences(results), *([f"{missing} runs did not complete"] if missing else [])])


main()

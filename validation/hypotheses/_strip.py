# SPDX-License-Identifier: GPL-3.0-or-later
"""Folds of a strip by their number: amplitudes at every output time, and the growth at which each would become unstable."""

import math
from pathlib import Path

import _layer
import _runs
import _vtk

CASE = Path(__file__).resolve().parent / "film.toml"
LAST_SHARE = 0.12  # of the film's thickness: amplitudes above it are not small
FIRST_SHARE = 0.5  # of the largest growth that is used: below it everything bends, not the fold alone
LEAST_POINTS = 6
LEAST_CORRELATION = 0.985  # of the points with their line


def top_row(references, displacements):
    """(x, mean displacement along z) of the nodes of the upper face, by x."""
    top = max(point[2] for point in references)
    by_x = {}
    for point, displacement in zip(references, displacements):
        if top - point[2] < 1e-6 * max(1.0, abs(top)):
            by_x.setdefault(round(point[0], 5), []).append(displacement[2])
    return [(x, sum(values) / len(values)) for x, values in sorted(by_x.items())]


def amplitudes(row, most):
    """Those of cos(n pi (x - x_0) / L) for n = 1 ... most, by the trapezium rule."""
    start, end = row[0][0], row[-1][0]
    length = end - start
    result = []
    for n in range(1, most + 1):
        total = 0.0
        for (x, u), (next_x, next_u) in zip(row, row[1:]):
            here, there = (math.cos(n * math.pi * (at - start) / length) for at in (x, next_x))
            total += 0.5 * (next_x - x) * (u * here + next_u * there)
        result.append(2 * total / length)
    return result


def history(folder, alpha, most):
    """Growth g and the amplitudes of the modes at every output time."""
    rows = _runs.read_measures(folder)
    result = []
    for number, row in enumerate(rows):
        references, displacements, _ = _vtk.read_surface(folder / f"surface_{number:04d}.vtp")
        result.append((1 + alpha * row["t"], amplitudes(top_row(references, displacements), most)))
    return result


def line(points):
    """Intercept, slope and correlation of a least-squares line."""
    count = len(points)
    mean_x = sum(x for x, _ in points) / count
    mean_y = sum(y for _, y in points) / count
    xx = sum((x - mean_x) ** 2 for x, _ in points)
    xy = sum((x - mean_x) * (y - mean_y) for x, y in points)
    yy = sum((y - mean_y) ** 2 for _, y in points)
    slope = xy / xx
    return mean_y - slope * mean_x, slope, xy / math.sqrt(xx * yy) if yy > 0 else 0.0


def small_part(past, mode, most_amplitude):
    """(g - 1, amplitude) up to the first amplitude of any mode that is not small, without the beginning."""
    points = []
    for growth, values in past:
        if max(map(abs, values)) > most_amplitude:
            break
        if growth > 1:
            points.append((growth - 1, values[mode - 1]))
    last = points[-1][0] if points else 0.0
    return [point for point in points if point[0] >= FIRST_SHARE * last]


def critical_growth(past, mode, most_amplitude=LAST_SHARE):
    """Southwell's plot: with e = g - 1, e / A falls linearly in e and is 0 at the critical growth.

    (growth, correlation), or (None, ...) where the mode does not grow that way.
    """
    points = [(e, e / a) for e, a in small_part(past, mode, most_amplitude) if a]
    if len(points) < LEAST_POINTS:
        return None, 0.0
    intercept, slope, correlation = line(points)
    critical = -intercept / slope if slope else -1.0
    if critical <= points[-1][0] * 0.9 or intercept * slope >= 0 or abs(correlation) < LEAST_CORRELATION:
        return None, correlation
    return 1 + critical, abs(correlation)


def first_mode(modes):
    """The first to become unstable; growth and wavelength from a parabola through it and its neighbours."""
    found = [mode for mode in modes if mode["growth"]]
    if not found:
        return {"growth": math.nan, "wavelength": math.nan}
    x, growth = _layer.least(sorted((math.log(mode["wavelength"]), mode["growth"]) for mode in found))
    return {"growth": growth, "wavelength": math.exp(x)}


def heights(folder, alpha):
    """Growth and half of the height from the deepest valley to the highest crown at every output time."""
    result = []
    for number, row in enumerate(_runs.read_measures(folder)):
        references, displacements, _ = _vtk.read_surface(folder / f"surface_{number:04d}.vtp")
        values = [height for _, height in top_row(references, displacements)]
        result.append((1 + alpha * row["t"], 0.5 * (max(values) - min(values))))
    return result


def mean_number(folder, alpha, most):
    """Half-waves in the length at the end: the mean over the modes, by their power."""
    power = [value**2 for value in history(folder, alpha, most)[-1][1]]
    return sum(n * share for n, share in enumerate(power, 1)) / sum(power)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Folds of a strip by their number: amplitudes at every output time, and the growth at which each would become unstable."""

import math
from pathlib import Path

import _layer
import _runs
import _vtk

CASE = Path(__file__).resolve().parent / "film.toml"
LAST_SHARE = 0.06  # of the film's thickness: amplitudes above it are not small
FIRST_SHARE = 0.4  # of the largest growth that is used: below it everything bends, not the fold alone
NEAR = 1.6         # times the wavelength of the first wave, or that part of it: those that the parabola is drawn through
LEAST_POINTS = 6
LEAST_EXPLAINED = 0.997  # of the variation of A / e
LEAST_GROWN = 0.01      # of the amplitude by that part at the end


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


def top_rows(folder, alpha):
    """Growth g and the upper face (see top_row) at every output time."""
    for number, row in enumerate(_runs.read_measures(folder)):
        references, displacements, _ = _vtk.read_surface(folder / f"surface_{number:04d}.vtp")
        yield 1 + alpha * row["t"], top_row(references, displacements)


def history(folder, alpha, most):
    """Growth g and the amplitudes of the modes at every output time."""
    return [(growth, amplitudes(row, most)) for growth, row in top_rows(folder, alpha)]


def parts(points, critical):
    """Least squares of A = a e / (1 - e/c) + b e: (a, b, sum of squares left over), each point by its size."""
    rows = [(1 / (1 - e / critical), 1.0, a / e) for e, a in points]
    pp, pq, qq = (sum(row[i] * row[j] for row in rows) for i, j in ((0, 0), (0, 1), (1, 1)))
    pr, qr = (sum(row[i] * row[2] for row in rows) for i in (0, 1))
    determinant = pp * qq - pq * pq
    grows, follows = (pr * qq - qr * pq) / determinant, (pp * qr - pq * pr) / determinant
    return grows, follows, sum((grows * p + follows * q - r) ** 2 for p, q, r in rows)


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
    """Growth at which a wave needs no force, and the share of the variation of A / e that the fit explains.

    With e = g - 1 a small wave is A = a e / (1 - e/c) + b e: what the imperfection becomes, more and more of it as growth nears
    1 + c (Southwell), and what bends in proportion to growth. (None, ...) where a wave does not grow that way.
    """
    points = small_part(past, mode, most_amplitude)
    if len(points) < LEAST_POINTS:
        return None, 0.0
    last = points[-1][0]
    tried = [last * (1.005 + 0.005 * k) for k in range(200)]
    critical = min(tried, key=lambda c: parts(points, c)[2])
    mean = sum(a / e for e, a in points) / len(points)
    explained = 1 - parts(points, critical)[2] / (sum((a / e - mean) ** 2 for e, a in points) or 1.0)
    grows = abs(parts(points, critical)[0]) * last / (1 - last / critical)
    if critical in (tried[0], tried[-1]) or explained < LEAST_EXPLAINED or grows < LEAST_GROWN:
        return None, explained
    return 1 + critical, explained


def modes_of(past, length, numbers):
    """Of waves with so many half-waves in the length: wavelength, critical growth and what the fit explains."""
    modes = []
    for n in numbers:
        growth, explained = critical_growth(past, n)
        modes.append({"n": n, "wavelength": 2 * length / n, "growth": growth, "explained": explained})
    return modes


def first_mode(modes):
    """The first to become unstable: growth and wavelength of the lowest point of the parabola closest to the waves near it."""
    found = [mode for mode in modes if mode["growth"]]
    if not found:
        return {"growth": math.nan, "wavelength": math.nan}
    lowest = min(found, key=lambda mode: mode["growth"])
    middle = math.log(lowest["wavelength"])
    near = [(math.log(mode["wavelength"]) - middle, mode["growth"]) for mode in found]
    near = [(x, growth) for x, growth in near if abs(x) < math.log(NEAR)]
    if len(near) < 3:
        return {"growth": lowest["growth"], "wavelength": lowest["wavelength"]}
    height, slope, bend = _layer.parabola(near)
    x = -0.5 * slope / bend if bend > 0 else 0.0
    if abs(x) > math.log(NEAR):
        return {"growth": lowest["growth"], "wavelength": lowest["wavelength"]}
    return {"growth": height + x * (slope + bend * x), "wavelength": math.exp(middle + x)}


def heights(folder, alpha):
    """Growth and half of the height from the deepest valley to the highest crown at every output time."""
    result = []
    for growth, row in top_rows(folder, alpha):
        values = [height for _, height in row]
        result.append((growth, 0.5 * (max(values) - min(values))))
    return result


def mean_number(folder, alpha, most):
    """Half-waves in the length at the end: the mean over the modes, by their power."""
    power = [value**2 for value in history(folder, alpha, most)[-1][1]]
    return sum(n * share for n, share in enumerate(power, 1)) / sum(power)


def visible_growth(past, least):
    """Growth at which half of the range of the surface passes `least`, linear between outputs; None: never."""
    for (growth, height), (next_growth, next_height) in zip(past, past[1:]):
        if height < least <= next_height:
            return growth + (next_growth - growth) * (least - height) / (next_height - height)
    return None

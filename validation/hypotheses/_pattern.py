# SPDX-License-Identifier: GPL-3.0-or-later
"""Where folds lie and which way they run, from surfaces with the same vertices."""

import math

import _vtk

POWERS = 4  # a cubic polynomial


class Surface:
    """Points, triangles, area of each vertex, and mean curvature (positive on gyri)."""

    def __init__(self, file):
        self.points = file.vectors("Points")
        self.triangles = file.vectors("connectivity")
        self.curvature = file.values("mean_curvature")
        self.areas = [0.0] * len(self.points)
        for triangle in self.triangles:
            area = 0.5 * math.hypot(*normal_of(*(self.points[k] for k in triangle)))
            for k in triangle:
                self.areas[k] += area / 3


def read(path):
    return Surface(_vtk.VtkFile(path))


def subtract(a, b):
    return tuple(x - y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def normal_of(a, b, c):
    """Normal of a triangle, twice its area long."""
    return cross(subtract(b, a), subtract(c, a))


def smoothed(surface, values, rounds=6):
    """Means over the neighbours, some rounds of it: folds and no grain."""
    for _ in range(rounds):
        sums, counts = list(values), [1] * len(values)
        for triangle in surface.triangles:
            for k in triangle:
                for other in triangle:
                    if other != k:
                        sums[k] += 0.5 * values[other]  # every edge belongs to two triangles
                        counts[k] += 0.5
        values = [total / count for total, count in zip(sums, counts)]
    return values


def directions(surface):
    """Shares of the squared gradient of curvature along x, y and z, over those of a surface that turns no way in particular.

    1 / 1 / 1: folds run every way; above 1 along an axis: folds lie across it. x is left to right, y back to front, z upwards.
    """
    values = smoothed(surface, surface.curvature)
    found, even = [0.0] * 3, [0.0] * 3
    for triangle in surface.triangles:
        points = [surface.points[k] for k in triangle]
        normal = normal_of(*points)
        twice_area = math.hypot(*normal)
        if twice_area == 0:
            continue
        unit = tuple(x / twice_area for x in normal)
        gradient = [0.0] * 3
        for corner in range(3):
            across = cross(unit, subtract(points[(corner + 2) % 3], points[(corner + 1) % 3]))
            for axis in range(3):
                gradient[axis] += values[triangle[corner]] * across[axis] / twice_area
        square = dot(gradient, gradient)
        for axis in range(3):
            found[axis] += twice_area * gradient[axis] ** 2
            even[axis] += twice_area * square * 0.5 * (1 - unit[axis] ** 2)
    return [a / b for a, b in zip(found, even)]


def solve(matrix, right):
    """Gauss's elimination with pivots."""
    rows = [list(row) + [value] for row, value in zip(matrix, right)]
    size = len(rows)
    for k in range(size):
        pivot = max(range(k, size), key=lambda r: abs(rows[r][k]))
        rows[k], rows[pivot] = rows[pivot], rows[k]
        for r in range(k + 1, size):
            factor = rows[r][k] / rows[k][k]
            rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k])]
    values = [0.0] * size
    for k in reversed(range(size)):
        values[k] = (rows[k][-1] - sum(rows[k][j] * values[j] for j in range(k + 1, size))) / rows[k][k]
    return values


def left_over(values, known, weights):
    """Values less the cubic polynomial of what is known that explains most of them."""
    mean = sum(w * x for w, x in zip(weights, known)) / sum(weights)
    size = math.sqrt(sum(w * (x - mean) ** 2 for w, x in zip(weights, known)) / sum(weights)) or 1.0
    powers = [[((x - mean) / size) ** p for p in range(POWERS)] for x in known]
    matrix = [[sum(w * row[a] * row[b] for w, row in zip(weights, powers)) for b in range(POWERS)] for a in range(POWERS)]
    right = [sum(w * row[a] * v for w, row, v in zip(weights, powers, values)) for a in range(POWERS)]
    factors = solve(matrix, right)
    return [v - dot(factors, row) for v, row in zip(values, powers)]


def agreement(start, one, other):
    """Correlation of the curvature of two surfaces after what the first body explains is taken out of both."""
    weights, known = start.areas, smoothed(start, start.curvature)
    a, b = (left_over(smoothed(surface, surface.curvature), known, weights) for surface in (one, other))
    ab = sum(w * x * y for w, x, y in zip(weights, a, b))
    aa, bb = (sum(w * x * x for w, x in zip(weights, values)) for values in (a, b))
    return ab / math.sqrt(aa * bb)


def dice(one, other):
    """Twice the common concave area over the sum of both, areas as on the first."""
    concave = [[value < 0 for value in smoothed(surface, surface.curvature)] for surface in (one, other)]
    both = sum(w for w, a, b in zip(one.areas, *concave) if a and b)
    return 2 * both / sum(w * (a + b) for w, a, b in zip(one.areas, *concave))

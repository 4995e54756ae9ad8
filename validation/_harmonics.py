# SPDX-License-Identifier: GPL-3.0-or-later
"""Power of a function on the sphere by degree: real spherical harmonics, summed directly over the vertices of a surface."""

import math


def vertex_areas(points, triangles):
    """A third of the area of the triangles around each vertex."""
    areas = [0.0] * len(points)
    for triangle in triangles:
        a, b, c = (points[i] for i in triangle)
        u = [q - p for p, q in zip(a, b)]
        v = [q - p for p, q in zip(a, c)]
        normal = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        share = math.hypot(*normal) / 6
        for i in triangle:
            areas[i] += share
    return areas


def recurrence(largest):
    """Factors (a, b) of the normalised Legendre functions: P_l^m = a (z P_{l-1}^m - b P_{l-2}^m)."""
    factors = {}
    for m in range(largest + 1):
        for degree in range(m + 1, largest + 1):
            a = math.sqrt((4 * degree**2 - 1) / (degree**2 - m**2))
            factors[degree, m] = (a, math.sqrt(((degree - 1)**2 - m**2) / (4 * (degree - 1)**2 - 1)))
    return factors


def coefficients(directions, weighted, largest):
    """Sums over the vertices of the weighted value times Y_lm: cosine and sine parts by (l, m)."""
    factors = recurrence(largest)
    cosines = {(degree, m): 0.0 for m in range(largest + 1) for degree in range(m, largest + 1)}
    sines = dict(cosines)
    for (x, y, z), value in zip(directions, weighted):
        sectoral = value * math.sqrt(1 / (4 * math.pi)) # Y_00, then Y_mm without its angle
        real, imaginary = 1.0, 0.0                      # (x + iy)^m
        for m in range(largest + 1):
            before, now = 0.0, sectoral
            for degree in range(m, largest + 1):
                if degree > m:
                    a, b = factors[degree, m]
                    before, now = now, a * (z * now - b * before)
                cosines[degree, m] += now * real
                sines[degree, m] += now * imaginary
            real, imaginary = x * real - y * imaginary, x * imaginary + y * real
            sectoral *= math.sqrt((2 * m + 3) / (2 * m + 2)) * (math.sqrt(2) if m == 0 else 1)
    return cosines, sines


def power_by_degree(directions, values, areas, largest):
    """Mean square of the part of each degree; their sum is the mean square of the function."""
    total = sum(areas)
    weighted = [value * area / total for value, area in zip(values, areas)]
    cosines, sines = coefficients(directions, weighted, largest)
    power = [0.0] * (largest + 1)
    for (degree, _), value in [*cosines.items(), *sines.items()]:
        power[degree] += 4 * math.pi * value * value
    return power


def wavelength(radius, degree):
    """2 pi R / sqrt(l (l + 1)), as Jeans has it."""
    return 2 * math.pi * radius / math.sqrt(degree * (degree + 1))

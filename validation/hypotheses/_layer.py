# SPDX-License-Identifier: GPL-3.0-or-later
"""Small waves on a film that grows on a base of finite depth, under a pressure: at which growth they need no force.

The theory of docs/theory/stability.md, with the depth of the base, the rollers below it and a pressure that follows the
surface; in thicknesses of the film before growth, and in shear moduli of the base.
"""

import functools
import math
from dataclasses import dataclass

LAYER_STEPS = 24
BASE_STEPS = 64
LARGEST_GROWTH = 2.0
GROWTH_STEP = 0.02
PRECISION = 1e-6
WAVE_STEP = 1.09


@dataclass(frozen=True)
class Strip:
    """What the onset depends on. bulk: of film and base, in their own shear moduli; isotropic: growth along the normal, too.

    is_fluid: the pressure acts on the area that there is; else its force stays that on the area before, along the normal.
    """

    ratio: float
    bulk: float
    depth: float = 8.0
    pressure: float = 0.0
    isotropic: bool = False
    is_fluid: bool = True


@dataclass(frozen=True)
class Moduli:
    """Incremental moduli about a compressed state: x in the plane, z across; thickness over that before."""

    thickness: float
    xxxx: float
    zzzz: float
    xxzz: float
    xzxz: float
    zxzx: float
    xzzx: float


def stress_across(in_plane, across, mu, bulk):
    """Cauchy stress along z."""
    volume = in_plane**2 * across
    squares = 2 * in_plane**2 + across**2
    return mu * volume ** (-5 / 3) * (across**2 - squares / 3) + bulk * (volume - 1)


def stretch_across(in_plane, mu, bulk, pressure):
    """The stretch at which the stress across is -pressure, by bisection: the stress rises with it."""
    low, high = 0.05, 20.0
    while high - low > 1e-13 * high:
        middle = 0.5 * (low + high)
        if stress_across(in_plane, middle, mu, bulk) < -pressure:
            low = middle
        else:
            high = middle
    return 0.5 * (low + high)


def moduli(in_plane, mu, bulk, pressure):
    """Of tissue with the elastic stretch in_plane along x and y, under a pressure across."""
    a, s = in_plane, stretch_across(in_plane, mu, bulk, pressure)
    volume = a * a * s
    scaled = mu * volume ** (-2 / 3)
    squares = 2 * a * a + s * s

    def own(stretch):
        return (scaled * (5 / 9 * squares - stretch**2 / 3) + bulk * volume**2) / volume

    stress = (scaled * (a * a - squares / 3) + bulk * (volume - 1) * volume) / volume
    cross = (scaled * (2 / 9 * squares - 2 / 3 * (a * a + s * s)) + bulk * volume * (2 * volume - 1)) / volume
    shear = scaled * a * a / volume
    return Moduli(s, own(a), own(s), cross, shear, scaled * s * s / volume, shear - stress)


def slope(tissue, k, wave):
    """d/dz of the amplitudes (u, w, shear traction, normal traction) of a wave in equilibrium."""
    u, w, shear, normal = wave
    du = (shear + tissue.xzzx * k * w) / tissue.zxzx
    dw = (normal - tissue.xxzz * k * u) / tissue.zzzz
    return du, dw, k * (tissue.xxxx * k * u + tissue.xxzz * dw), k * (tissue.xzxz * k * w - tissue.xzzx * du)


def carried(tissue, k, wave, thickness, steps):
    """The wave after a layer, by the Runge-Kutta method."""
    h = thickness / steps

    def moved(by, along):
        return tuple(a + by * b for a, b in zip(wave, along))

    for _ in range(steps):
        first = slope(tissue, k, wave)
        second = slope(tissue, k, moved(h / 2, first))
        third = slope(tissue, k, moved(h / 2, second))
        fourth = slope(tissue, k, moved(h, third))
        wave = tuple(a + h / 6 * (p + 2 * q + 2 * r + s)
                     for a, p, q, r, s in zip(wave, first, second, third, fourth))
    return wave


def surface_determinant(strip, growth, wavelength):
    """0 where a wave of this length needs no force: two waves from the rollers below, carried to the surface."""
    k = 2 * math.pi / wavelength
    base = moduli(1.0, 1.0, strip.bulk, strip.pressure)
    film = moduli(1 / growth, strip.ratio, strip.bulk * strip.ratio, strip.pressure)
    thickness = film.thickness * (growth if strip.isotropic else 1.0)
    ends = []
    for start in ((1.0, 0.0, 0.0, 0.0), (0.0, 0.0, 0.0, 1.0)):
        wave = carried(base, k, start, (strip.depth - 1) * base.thickness, BASE_STEPS)
        size = max(map(abs, wave))
        wave = tuple(part / size for part in wave)
        u, w, shear, normal = carried(film, k, wave, thickness, LAYER_STEPS)
        ends.append((shear + strip.pressure * k * w, normal + strip.pressure * k * u * strip.is_fluid))
    (first_shear, first_normal), (second_shear, second_normal) = ends
    return first_shear * second_normal - first_normal * second_shear


def onset(strip, wavelength):
    """Growth at which this wavelength becomes unstable; None: not below LARGEST_GROWTH."""
    flat = surface_determinant(strip, 1.0, wavelength)
    stable = 1.0
    while flat * surface_determinant(strip, stable + GROWTH_STEP, wavelength) > 0:
        stable += GROWTH_STEP
        if stable > LARGEST_GROWTH:
            return None
    unstable = stable + GROWTH_STEP
    while unstable - stable > PRECISION:
        middle = 0.5 * (stable + unstable)
        if flat * surface_determinant(strip, middle, wavelength) > 0:
            stable = middle
        else:
            unstable = middle
    return unstable


def least(points):
    """(x, y) of the lowest of points, or of the parabola through it and its neighbours; sorted by x."""
    lowest = min(range(len(points)), key=lambda k: points[k][1])
    if not 0 < lowest < len(points) - 1:
        return points[lowest]
    (x0, y0), (x1, y1), (x2, y2) = points[lowest - 1:lowest + 2]
    lower, upper = (y1 - y0) / (x1 - x0), (y2 - y1) / (x2 - x1)
    curvature = (upper - lower) / (x2 - x0)
    if curvature <= 0:
        return points[lowest]
    x = 0.5 * (x0 + x1) - 0.5 * lower / curvature
    return x, y0 + (x - x0) * (lower + curvature * (x - x1))


def parabola(points):
    """(c, b, a) of the c + b x + a x² closest to at least three points."""
    sums = [sum(x**power for x, _ in points) for power in range(5)]
    rows = [[sums[i + j] for j in range(3)] + [sum(y * x**i for x, y in points)] for i in range(3)]
    for k in range(3):
        for r in range(3):
            if r != k:
                factor = rows[r][k] / rows[k][k]
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[k])]
    return tuple(rows[k][3] / rows[k][k] for k in range(3))


@functools.lru_cache(maxsize=None)
def critical(strip, around):
    """(growth, wavelength) of the wave that becomes unstable first, among those near a wavelength."""
    waves = [around * WAVE_STEP**k for k in range(-4, 4)]
    found = [(math.log(wave), growth) for wave, growth in ((wave, onset(strip, wave)) for wave in waves) if growth]
    if not found:
        return math.nan, math.nan
    x, growth = least(found)
    return growth, math.exp(x)


def strain(growth):
    """Compression of a film that cannot extend: it would be `growth` times as long."""
    return 1 - 1 / growth

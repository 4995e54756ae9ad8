# SPDX-License-Identifier: GPL-3.0-or-later
"""A closed, wavy surface of two lobes, curved like a bean: what a brain's outer surface asks of the command, from a formula."""

import math

SEMI_AXES_MM = (15.0, 19.0, 13.0)
FISSURE_DEPTH = 0.28   # of the radius, along the middle plane on top
FISSURE_WIDTH = 0.22   # of the radius
WAVE_HEIGHT = 0.025    # of the radius
BEND_PER_MM = 0.008    # lowers both ends: z falls by this times y^2


def radius(x, y, z):
    """Radius over that of the ellipsoid, in the direction (x, y, z) of length 1."""
    top = max(0.0, z + 0.3) / 1.3
    fissure = FISSURE_DEPTH * top * math.exp(-(x / FISSURE_WIDTH) ** 2)
    waves = WAVE_HEIGHT * math.sin(6 * y + 1) * math.cos(5 * z) * math.cos(4 * x)
    return 1 - fissure + waves


def two_lobes(directions):
    """Positions [mm] for directions of length 1. A radius per direction and a shear along z: it never meets itself."""
    vertices = []
    for direction in directions:
        scale = radius(*direction)
        x, y, z = (scale * axis * component for axis, component in zip(SEMI_AXES_MM, direction))
        vertices.append((x, y, z - BEND_PER_MM * y * y))
    return vertices

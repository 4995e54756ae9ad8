# SPDX-License-Identifier: GPL-3.0-or-later
"""Folds of the standard sphere by spherical-harmonic degree, read from a run folder."""

import math

import _harmonics
import _runs
import _vtk

RADIUS_MM = 12.496
LARGEST_DEGREE = 20

# Second variation of the unfolded state: g = 1.441, degree 8 or 9 first.
THEORY_ONSET_T = 0.241


def spectrum(folder, t):
    """Power [mm^2] of the radial displacement by degree at the output time nearest to t, and that time."""
    row, measures = _runs.nearest_row(_runs.read_measures(folder), t)
    points, displacements, triangles = _vtk.read_surface(folder / f"surface_{row:04d}.vtp")
    directions = [tuple(x / math.hypot(*point) for x in point) for point in points]
    radial = [sum(n * u for n, u in zip(direction, displacement))
              for direction, displacement in zip(directions, displacements)]
    areas = _harmonics.vertex_areas(points, triangles)
    return _harmonics.power_by_degree(directions, radial, areas, LARGEST_DEGREE), measures["t"]


def fold_width(folder, t):
    """Degrees of the folds at an output time, and their wavelengths on the reference sphere."""
    power, found_t = spectrum(folder, t)
    folds = range(1, len(power)) # degree 0 is growth as a whole
    dominant = max(folds, key=power.__getitem__)
    mean = sum(degree * power[degree] for degree in folds) / sum(power[1:])
    return {"t": found_t, "power_mm2": power, "dominant_degree": dominant, "mean_degree": mean,
            "dominant_wavelength_mm": _harmonics.wavelength(RADIUS_MM, dominant),
            "mean_wavelength_mm": _harmonics.wavelength(RADIUS_MM, mean)}

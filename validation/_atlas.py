# SPDX-License-Identifier: GPL-3.0-or-later
"""Real fetal brains by week, which grown ones are set beside."""

# Labels of an atlas (CHN fetal atlas, cerebrum without cerebellum and brainstem; averaged brains, so that area and index are
# lower bounds of individuals'), measured by `corticle measure`; cortex by voxels, thickness by volume over the mean area of the
# two surfaces of the cortex.
TARGETS = {
    "volume_cm3": {23: 62.7, 25: 84, 27: 114, 28: 128.0, 29: 143, 31: 172, 33: 201.8, 34: 226.8, 36: 280.4, 38: 312.8},
    "length_mm": {23: 64.0, 24: 69.6, 26: 75.2, 28: 80.1, 30: 88.2, 32: 94.8, 33: 95.8, 34: 100.0, 36: 105.5, 38: 107.2},
    "area_cm2": {23: 112.6, 25: 143, 27: 170, 28: 189.6, 29: 209, 31: 242, 33: 279.4, 34: 297.9, 36: 351.0, 38: 368.3},
    "gi_hull": {23: 1.180, 24: 1.201, 26: 1.209, 28: 1.263, 30: 1.324, 32: 1.354, 33: 1.359, 34: 1.336, 36: 1.376, 38: 1.358},
    "sulcal_depth_mean_mm": {23: 3.53, 24: 3.77, 26: 3.64, 28: 4.12, 30: 4.81, 32: 4.91, 33: 4.98, 34: 5.03, 36: 5.56, 38: 5.61},
    "cortex_cm3": {23: 18.6, 25: 25.9, 27: 37.2, 28: 42.3, 29: 49.5, 31: 61.7, 33: 74.9, 34: 83.6, 36: 108.5, 38: 118.8},
    "cortex_thickness_mm": {23: 1.71, 25: 1.89, 27: 2.23, 29: 2.39, 31: 2.49, 34: 2.56, 36: 2.63, 38: 2.73},
}

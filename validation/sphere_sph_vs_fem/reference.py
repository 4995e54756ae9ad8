# SPDX-License-Identifier: GPL-3.0-or-later
"""What others got on this sphere."""

# A finite-element code of the Tallinen lineage: smooth layer H = 1.674 mm, mu 1 and 1.167, K = 5.
# (growth time, with 100,265 tets, with 253,137), each (area mm2, volume mm3, area over hull).
LINEAGE = [
    (0.244, (2366, 10818, 1.000), (2368, 10834, 1.000)),
    (0.348, (2519, 11866, 1.000), (2519, 11880, 1.000)),
    (0.450, (3784, 13387, 1.253), (4156, 13551, 1.373)),
    (0.544, (4816, 14963, 1.441), (5202, 15108, 1.592)),
    (0.627, (5640, 16452, 1.561), (6026, 16608, 1.718)),
    (0.699, (6331, 17773, 1.647), (6713, 17958, 1.804)),
    (0.758, (6904, 18920, 1.709), (7303, 19142, 1.869)),
    (0.877, (8071, 21351, 1.817), (8528, 21661, 1.982)),
]

# Thesis Table 6: (name, area mm2, volume mm3, area / volume, index, growth time reached).
TABLE_6 = [("thesis, SPH, 45,000 particles", 11589.99, 10895.57, 1.06, 4.67, "0.043, diverged"),
           ("thesis, FEM, 223,000 tets", 7135.26, 17755.59, 0.40, 1.93, "1")]

ONSET_A = 0.241 # theory, binary layer

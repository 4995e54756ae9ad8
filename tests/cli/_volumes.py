# SPDX-License-Identifier: GPL-3.0-or-later
"""Small label volumes."""

import struct


def nifti(labels, size, voxel=1.0, datatype=2, bits=8, dims=None):
    """A NIfTI-1 file of bytes, centred on the origin."""
    header = bytearray(352)
    struct.pack_into("<i", header, 0, 348)
    struct.pack_into("<8h", header, 40, *(dims or (3, *size, 1, 1, 1, 1)))
    struct.pack_into("<2h", header, 70, datatype, bits)
    struct.pack_into("<8f", header, 76, 1, voxel, voxel, voxel, 1, 1, 1, 1)
    struct.pack_into("<2f", header, 108, 352, 1)
    header[123] = 2 # mm
    struct.pack_into("<2h", header, 252, 0, 1)
    for row in range(3):
        values = [0.0, 0.0, 0.0, -0.5 * voxel * (size[row] - 1)]
        values[row] = voxel
        struct.pack_into("<4f", header, 280 + 16 * row, *values)
    header[344:348] = b"n+1\0"
    return bytes(header) + bytes(labels)

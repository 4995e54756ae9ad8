# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the .vtp and .vtu files of a run: arrays appended raw, headers of 64 bits; older runs compressed them by zlib."""

import array
import struct
import sys
import xml.etree.ElementTree as ElementTree
import zlib
from pathlib import Path

TYPE_CODES = {"Float64": "d", "Float32": "f", "Int64": "q", "Int32": "i", "UInt8": "B"}
START = b'<AppendedData encoding="raw">'


class VtkFile:
    """Names of the arrays, and their values as flat arrays in the order of the file."""

    def __init__(self, path):
        data = Path(path).read_bytes()
        cut = data.find(START)
        if cut < 0:
            raise ValueError(f"{path}: no appended raw data")
        self.data = data
        self.begin = data.index(b"_", cut) + 1
        root = ElementTree.fromstring(data[:cut] + b"</VTKFile>")
        encoding = [root.get(key) for key in ("byte_order", "header_type", "compressor")]
        if encoding[:2] != ["LittleEndian", "UInt64"] or encoding[2] not in (None, "vtkZLibDataCompressor"):
            raise ValueError(f"{path}: encoding {encoding} is not read here")
        self.is_compressed = encoding[2] is not None
        self.arrays = {element.get("Name"): element for element in root.iter("DataArray")}

    def bytes_at(self, at):
        """The bytes of an array: their number, then they; or the numbers and sizes of blocks, then these."""
        if not self.is_compressed:
            size, = struct.unpack_from("<Q", self.data, at)
            return self.data[at + 8:at + 8 + size]
        blocks, _, _ = struct.unpack_from("<3Q", self.data, at)
        sizes = struct.unpack_from(f"<{blocks}Q", self.data, at + 24)
        at += 24 + 8 * blocks
        parts = []
        for size in sizes:
            parts.append(zlib.decompress(self.data[at:at + size]))
            at += size
        return b"".join(parts)

    def values(self, name):
        element = self.arrays[name]
        result = array.array(TYPE_CODES[element.get("type")])
        result.frombytes(self.bytes_at(self.begin + int(element.get("offset"))))
        if sys.byteorder == "big":
            result.byteswap()
        return result

    def vectors(self, name):
        """Values of an array of three components, as tuples."""
        flat = iter(self.values(name))
        return list(zip(flat, flat, flat))


def read_surface(path):
    """(reference positions, displacements, triangles) of a surface file."""
    file = VtkFile(path)
    displacements = file.vectors("displacement")
    references = [tuple(p - u for p, u in zip(point, displacement))
                  for point, displacement in zip(file.vectors("Points"), displacements)]
    return references, displacements, file.vectors("connectivity")

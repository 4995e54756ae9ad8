# SPDX-License-Identifier: GPL-3.0-or-later
"""A run folder with a large surface: that of a small run whose surface files are exchanged for a folded ball of any number
of vertices, with arrays as rough as those of real runs."""

import struct

SCALARS = ("J", "theta", "growth", "mean_curvature", "gaussian_curvature", "shape_index", "curvedness", "sulcal_depth",
           "local_gyrification", "thickness", "von_mises", "id")


def ball(numpy, count):
    """(unit points, triangles) of an octahedron split until it has `count` vertices or more; along a space-filling curve."""
    points = numpy.array([[1, 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]], float)
    corners = numpy.array([[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]])
    n = 1
    while 4 * n * n + 2 < count:
        n += 1
    rows = [numpy.array([[i, j, n - i - j] for i in range(n + 1) for j in range(n + 1 - i)])]
    number = {tuple(row): k for k, row in enumerate(rows[0])}
    small = [[number[i, j, n - i - j], number[i + 1, j, n - i - j - 1], number[i, j + 1, n - i - j - 1]]
             for i in range(n) for j in range(n - i)]
    small += [[number[i + 1, j, n - i - j - 1], number[i + 1, j + 1, n - i - j - 2], number[i, j + 1, n - i - j - 1]]
              for i in range(n - 1) for j in range(n - 1 - i)]
    weights, small = rows[0] / n, numpy.array(small)
    whole = numpy.concatenate([weights @ points[face] for face in corners])
    triangles = numpy.concatenate([small + k * len(weights) for k in range(len(corners))])
    grid = numpy.round(whole * n).astype(int) + n  # exact: each point lies on a grid
    spread = numpy.zeros(len(grid), dtype=numpy.int64)
    for bit in range(12):
        for axis in range(3):
            spread |= ((grid[:, axis] >> bit) & 1).astype(numpy.int64) << (3 * bit + axis)
    _, first, inverse = numpy.unique(spread, return_index=True, return_inverse=True)
    kept = whole[first]
    return kept / numpy.linalg.norm(kept, axis=1)[:, None], inverse.reshape(-1)[triangles]


def write_vtp(numpy, path, points, triangles, fields):
    """A .vtp as runs write it: appended, uncompressed doubles."""
    blocks, offset, arrays = [], 0, []

    def add(name, array, components, kind):
        nonlocal offset
        data = numpy.ascontiguousarray(array).tobytes()
        blocks.append(struct.pack("<Q", len(data)) + data)
        text = f'<DataArray type="{kind}" Name="{name}" NumberOfComponents="{components}" format="appended" offset="{offset}"/>'
        offset += len(blocks[-1])
        return text

    for name, values in fields.items():
        arrays.append(add(name, values, 1 if values.ndim == 1 else values.shape[1], "Float64"))
    place = add("Points", points, 3, "Float64")
    connectivity = add("connectivity", triangles.astype("<i8"), 1, "Int64")
    ends = add("offsets", numpy.arange(3, 3 * len(triangles) + 1, 3, dtype="<i8"), 1, "Int64")
    head = (f'<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" header_type="UInt64">\n<PolyData>\n'
            f'<Piece NumberOfPoints="{len(points)}" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="0" '
            f'NumberOfPolys="{len(triangles)}">\n'
            f'<PointData>{"".join(arrays)}</PointData>\n<Points>{place}</Points>\n<Polys>{connectivity}{ends}</Polys>\n'
            '</Piece>\n</PolyData>\n<AppendedData encoding="raw">\n_')
    path.write_bytes(head.encode() + b"".join(blocks) + b"\n</AppendedData>\n</VTKFile>\n")


def enlarge(numpy, folder, count):
    """Exchanges the surface files of a run."""
    directions, triangles = ball(numpy, count)
    random = numpy.random.default_rng(1)
    waves = random.normal(size=(40, 3)) * 9.0
    files = sorted(folder.glob("surface_*.vtp"))
    for k, path in enumerate(files):
        share = k / (len(files) - 1)
        folds = numpy.mean(numpy.sin(directions @ waves.T + numpy.arange(40)), axis=1)
        rough = random.normal(size=len(directions))
        radius = 30.0 + 12.0 * share + 25.0 * share * folds + 1e-2 * rough
        points = directions * radius[:, None]
        fields = {name: (1 + i + share) * folds + 0.02 * random.normal(size=len(directions)) for i, name in enumerate(SCALARS)}
        fields["cortex_boundary"] = points - 2.5 * directions
        write_vtp(numpy, path, points, triangles, fields)
    return len(directions)

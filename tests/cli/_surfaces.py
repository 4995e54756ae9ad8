# SPDX-License-Identifier: GPL-3.0-or-later
"""Small surfaces, good and bad: (vertices, triangles) and their files."""

import math
import struct


def icosphere(radius=10.0, subdivisions=2, centre=(0.0, 0.0, 0.0)):
    """A closed sphere, triangles counter-clockwise seen from outside."""
    golden = (1 + math.sqrt(5)) / 2
    vertices = [(-1, golden, 0), (1, golden, 0), (-1, -golden, 0), (1, -golden, 0), (0, -1, golden), (0, 1, golden),
                (0, -1, -golden), (0, 1, -golden), (golden, 0, -1), (golden, 0, 1), (-golden, 0, -1), (-golden, 0, 1)]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11),
                 (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(subdivisions):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                vertices.append(tuple((p + q) / 2 for p, q in zip(vertices[a], vertices[b])))
                middles[key] = len(vertices) - 1
            return middles[key]

        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        triangles = finer
    scaled = []
    for vertex in vertices:
        length = math.sqrt(sum(x * x for x in vertex))
        scaled.append(tuple(radius * x / length + c for x, c in zip(vertex, centre)))
    return scaled, triangles


def joined(a, b):
    """Both surfaces in one."""
    shift = len(a[0])
    return a[0] + b[0], a[1] + [tuple(v + shift for v in triangle) for triangle in b[1]]


def flipped(surface):
    return surface[0], [(a, c, b) for a, b, c in surface[1]]


def moved(surface, vertex, position):
    vertices = list(surface[0])
    vertices[vertex] = position
    return vertices, surface[1]


def volume(surface):
    """Volume enclosed (divergence theorem)."""
    total = 0.0
    for a, b, c in surface[1]:
        p, q, r = surface[0][a], surface[0][b], surface[0][c]
        total += (p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) +
                  p[2] * (q[0] * r[1] - q[1] * r[0])) / 6
    return total


def off(surface):
    lines = ["OFF", f"{len(surface[0])} {len(surface[1])} 0"]
    lines += [" ".join(repr(x) if math.isfinite(x) else "nan" for x in vertex) for vertex in surface[0]]
    lines += ["3 {} {} {}".format(*triangle) for triangle in surface[1]]
    return "\n".join(lines) + "\n"


def obj(surface):
    return "".join("v {!r} {!r} {!r}\n".format(*v) for v in surface[0]) + "".join(
        f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in surface[1])


def stl(surface):
    """Binary."""
    data = bytes(80) + struct.pack("<I", len(surface[1]))
    for triangle in surface[1]:
        data += struct.pack("<3f", 0, 0, 0)
        data += b"".join(struct.pack("<3f", *surface[0][v]) for v in triangle) + bytes(2)
    return data


def bad_surfaces():
    """name -> (file name, content, what the message must say)."""
    ball = icosphere()
    open_ball = ball[0], ball[1][1:]
    apart = joined(ball, icosphere(centre=(30.0, 0.0, 0.0)))
    pierced = moved(ball, 0, tuple(-1.5 * x for x in ball[0][0]))
    flat = [(x, y, 0.0) for x, y, _ in ball[0]], ball[1]
    corner = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)], [(0, 2, 1), (0, 1, 3), (1, 2, 3),
                                                                                   (0, 3, 2)]
    fins = corner[0], corner[1] + [(0, 1, 2)]
    return {
        "open": ("open.off", off(open_ball), ["open.off", "3 boundary edges"]),
        "self-intersecting": ("pierced.off", off(pierced), ["pierced.off", "intersect"]),
        "inside-out": ("inside.stl", stl(flipped(ball)), ["inside.stl", "inside-out"]),
        "several components": ("apart.obj", obj(apart), ["apart.obj", "2 components"]),
        "zero volume": ("flat.off", off(flat), ["flat.off"]),
        "not manifold": ("fins.off", off(fins), ["fins.off", "manifold"]),
        "NaN vertex": ("nan.off", off(moved(ball, 5, (math.nan, 0.0, 0.0))), ["nan.off"]),
        "bad index": ("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", ["index.off"]),
        "prose": ("prose.stl", "once upon a time\n", ["prose.stl"]),
        "prose in OFF": ("prose.off", "once upon a time\n", ["prose.off"]),
        "unknown format": ("surface.docx", "PK", ["surface.docx"]),
        "empty": ("empty.ply", "", ["empty.ply"]),
        "truncated": ("short.stl", stl(ball)[:-60], ["short.stl"]),
        "huge counts": ("huge.off", "OFF\n2000000000 2000000000 0\n0 0 0\n", ["huge.off"]),
        "huge STL count": ("huge.stl", bytes(80) + b"\xff\xff\xff\xff" + bytes(100), ["huge.stl"]),
    }

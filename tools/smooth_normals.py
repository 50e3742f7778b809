"""Normals for the meshes that tools/make-* write: smooth and in single precision, with the same result as a reader that
sums the triangle normals around each vertex, weighted by area."""
import itertools
import math
import struct


def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def length(v):
    x, y, z = (single(c * c) for c in v)
    return single(math.sqrt(single(single(x + y) + z)))


def cross(a, b):
    return [single(single(a[i] * b[j]) - single(b[i] * a[j])) for i, j in ((1, 2), (2, 0), (0, 1))]


def unit(v):
    size = length(v)
    return [single(c / size) for c in v] if size > 0 else [0.0, 1.0, 0.0]


def stored(normal):
    """Returns the normal, or a slightly shorter vector that a reader's division by its length turns into the normal."""
    for part in range(60):
        for way in itertools.product((0, -1, 1), repeat=3):
            near = [single(single(c * (1 - part * 1e-6)) + w * 2 ** (math.frexp(c)[1] - 24)) for c, w in zip(normal, way)]
            if unit(near) == normal:
                return near
    return normal


def smooth_normals(places, triangles, keys=None):
    """Returns a unit normal for each position. Vertices with the same key share a normal; without keys, vertices with
    the same index."""
    places = [[single(c) for c in place] for place in places]
    keys = list(range(len(places))) if keys is None else keys
    sums = {}
    for triangle in triangles:
        a, b, c = (places[i] for i in triangle)
        normal = cross([single(q - p) for p, q in zip(a, b)], [single(q - p) for p, q in zip(a, c)])
        for i in triangle:
            sums[keys[i]] = [single(p + q) for p, q in zip(sums.get(keys[i], [0.0, 0.0, 0.0]), normal)]
    known = {key: stored(unit(total)) for key, total in sums.items()}
    return [known.get(key, [0.0, 1.0, 0.0]) for key in keys]

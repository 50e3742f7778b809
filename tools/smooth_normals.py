"""Normals for the meshes that tools/make-* write: smooth, in single precision, as a reader would compute them that adds up
the triangles around each vertex, weighted by their area."""
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
    """The normal, or one a hair shorter that a reader's own division by the length turns into it."""
    for part in range(60):
        for way in itertools.product((0, -1, 1), repeat=3):
            near = [single(single(c * (1 - part * 1e-6)) + w * 2 ** (math.frexp(c)[1] - 24)) for c, w in zip(normal, way)]
            if unit(near) == normal:
                return near
    return normal


def smooth_normals(places, triangles, keys=None):
    """A unit normal for each place. Vertices with the same key are one; without keys those with the same number."""
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

"""LDR-FLIP implemented directly from its definition (Andersson et al. 2020, sections 4 and 5), as a reference for the
renderer's implementation: two-dimensional filters, direct convolution, double precision. Slow: for pictures of a few
hundred pixels.

A picture is a list of rows of (r, g, b), 0 to 255."""
import math

PPD = 0.7 * 3840 / 0.7 * math.pi / 180
# Exact fractions of the matrix for sRGB primaries and white point D65.
TO_XYZ = [[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
          [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
          [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]]
WHITE = [sum(row) for row in TO_XYZ]


def product(matrix, vector):
    return [sum(m * v for m, v in zip(row, vector)) for row in matrix]


def solve(matrix, right):
    """Solves three linear equations by Cramer's rule."""
    def det(m):
        return (m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
                + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]))

    def replaced(column):
        return [[right[i] if j == column else matrix[i][j] for j in range(3)] for i in range(3)]
    return [det(replaced(column)) / det(matrix) for column in range(3)]


def linear(byte):
    value = byte / 255
    return ((value + 0.055) / 1.055) ** 2.4 if value > 0.04045 else value / 12.92


def ycxcz(pixel):
    x, y, z = (value / white for value, white in zip(product(TO_XYZ, [linear(c) for c in pixel]), WHITE))
    return 116 * y - 16, 500 * (x - y), 200 * (y - z)


def filtered_rgb(colour):
    """Converts an opponent colour to linear RGB, clamped to the unit cube."""
    y = (colour[0] + 16) / 116
    xyz = [y + colour[1] / 500, y, y - colour[2] / 200]
    return [min(1, max(0, c)) for c in solve(TO_XYZ, [value * white for value, white in zip(xyz, WHITE)])]


def hunt_lab(rgb):
    def root(t):
        return t ** (1 / 3) if t > (6 / 29) ** 3 else t / (3 * (6 / 29) ** 2) + 4 / 29
    x, y, z = (root(value / white) for value, white in zip(product(TO_XYZ, rgb), WHITE))
    lightness = 116 * y - 16
    return lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z)


def hyab(a, b):
    return abs(a[0] - b[0]) + math.hypot(a[1] - b[1], a[2] - b[2])


def contrast_filter(a1, b1, a2, b2):
    radius = math.ceil(3 * math.sqrt(0.04 / (2 * math.pi ** 2)) * PPD)

    def weight(x, y):
        squared = (x * x + y * y) / PPD ** 2
        return (a1 * math.sqrt(math.pi / b1) * math.exp(-math.pi ** 2 * squared / b1)
                + a2 * math.sqrt(math.pi / b2) * math.exp(-math.pi ** 2 * squared / b2))
    weights = {(x, y): weight(x, y) for x in range(-radius, radius + 1) for y in range(-radius, radius + 1)}
    total = sum(weights.values())
    return {at: value / total for at, value in weights.items()}


def feature_filter(kind, along):
    sd = 0.5 * 0.082 * PPD
    radius = math.ceil(3 * sd)
    weights = {}
    for x in range(-radius, radius + 1):
        for y in range(-radius, radius + 1):
            t = x if along == "x" else y
            g = math.exp(-(x * x + y * y) / (2 * sd * sd))
            weights[x, y] = -t * g if kind == "edge" else (t * t / (sd * sd) - 1) * g
    positive = sum(w for w in weights.values() if w > 0)
    negative = -sum(w for w in weights.values() if w < 0)
    return {at: w / (positive if w > 0 else negative) for at, w in weights.items()}


def convolved(plane, kernel):
    """Convolves a plane with a kernel; the border values are repeated outside."""
    height, width = len(plane), len(plane[0])
    reach = max(x for x, _ in kernel)
    wide = [[plane[min(max(y, 0), height - 1)][min(max(x, 0), width - 1)] for x in range(-reach, width + reach)]
            for y in range(-reach, height + reach)]
    items = list(kernel.items())
    return [[math.fsum(w * wide[y + reach + dy][x + reach + dx] for (dx, dy), w in items) for x in range(width)]
            for y in range(height)]


class Seen:
    """The filtered colours of a picture, and the strength of its edges and points per pixel."""

    def __init__(self, picture):
        planes = list(zip(*[list(zip(*[ycxcz(pixel) for pixel in row])) for row in picture]))
        filters = [contrast_filter(1, 0.0047, 0, 1e-5), contrast_filter(1, 0.0053, 0, 1e-5),
                   contrast_filter(34.1, 0.04, 13.5, 0.025)]
        y, cx, cz = (convolved(plane, kernel) for plane, kernel in zip(planes, filters))
        self.colours = [[hunt_lab(filtered_rgb(c)) for c in zip(*rows)] for rows in zip(y, cx, cz)]
        grey = [[(value + 16) / 116 for value in row] for row in planes[0]]
        self.features = []
        for kind in ("edge", "point"):
            x, y = (convolved(grey, feature_filter(kind, along)) for along in "xy")
            self.features.append([[math.hypot(*pair) for pair in zip(*rows)] for rows in zip(x, y)])


def flip_mean(a, b):
    largest = hyab(hunt_lab([0, 1, 0]), hunt_lab([0, 0, 1])) ** 0.7
    seen_a, seen_b = Seen(a), Seen(b)
    errors = []
    for y, row in enumerate(a):
        for x in range(len(row)):
            error = hyab(seen_a.colours[y][x], seen_b.colours[y][x]) ** 0.7
            if error < 0.4 * largest:
                colour = 0.95 / (0.4 * largest) * error
            else:
                colour = 0.95 + (error - 0.4 * largest) / (0.6 * largest) * 0.05
            feature = max(abs(p[y][x] - q[y][x]) for p, q in zip(seen_a.features, seen_b.features))
            errors.append(colour ** (1 - (feature / math.sqrt(2)) ** 0.5))
    return math.fsum(errors) / len(errors)

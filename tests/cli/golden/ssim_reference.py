"""SSIM implemented directly from its definition (Wang, Bovik, Sheikh, Simoncelli 2004, equations 13 to 16), for any
window. With ffmpeg's window it is compared with ffmpeg, with the Gaussian window with scikit-image and with the
renderer.

A picture is a list of rows of (r, g, b), 0 to 255."""
import math

C1, C2 = (0.01 * 255) ** 2, (0.03 * 255) ** 2


def gaussian_window():
    """Returns an 11x11 Gaussian window with sigma 1.5 and sum 1."""
    weights = {(x, y): math.exp(-(x * x + y * y) / (2 * 1.5 ** 2)) for x in range(-5, 6) for y in range(-5, 6)}
    total = sum(weights.values())
    return {at: weight / total for at, weight in weights.items()}


def block_window():
    """Returns an 8x8 window of equal weights."""
    return {(x, y): 1 / 64 for x in range(8) for y in range(8)}


def mirrored(i, count):
    """Mirrors an index at the borders, c b a | a b c | c b a, as scipy.ndimage's "reflect"."""
    i %= 2 * count
    return min(i, 2 * count - 1 - i)


def local_ssim(a, b, channel, at, window, variance_scale):
    """Returns the SSIM in a window around (or from) one pixel; the picture is mirrored outside."""
    height, width = len(a), len(a[0])

    def mean(value):
        return math.fsum(weight * value(mirrored(at[0] + dx, width), mirrored(at[1] + dy, height))
                         for (dx, dy), weight in window.items())

    def one(picture):
        return lambda x, y: picture[y][x][channel]
    mean_a, mean_b = mean(one(a)), mean(one(b))
    variance_a = mean(lambda x, y: (a[y][x][channel] - mean_a) ** 2) * variance_scale
    variance_b = mean(lambda x, y: (b[y][x][channel] - mean_b) ** 2) * variance_scale
    covariance = mean(lambda x, y: (a[y][x][channel] - mean_a) * (b[y][x][channel] - mean_b)) * variance_scale
    return ((2 * mean_a * mean_b + C1) * (2 * covariance + C2)
            / ((mean_a ** 2 + mean_b ** 2 + C1) * (variance_a + variance_b + C2)))


def mean_ssim(a, b, places, window, variance_scale=1):
    values = [local_ssim(a, b, channel, at, window, variance_scale) for channel in range(3) for at in places]
    return math.fsum(values) / len(values)


def middles(side):
    """Returns the positions that scikit-image uses: at least 5 from the border. For sides below 11, which scikit-image
    refuses, all positions."""
    return range(5, side - 5) if side > 10 else range(side)


def gaussian_ssim(a, b):
    """Equals scikit-image's structural_similarity with gaussian_weights, sigma 1.5 and use_sample_covariance=False."""
    return mean_ssim(a, b, [(x, y) for y in middles(len(a)) for x in middles(len(a[0]))], gaussian_window())


def ffmpeg_ssim(a, b):
    """Equals ffmpeg's ssim: 8x8 blocks every 4 pixels, completely inside a size rounded down to 4; sample variances."""
    places = [(x, y) for y in range(0, len(a) // 4 * 4 - 7, 4) for x in range(0, len(a[0]) // 4 * 4 - 7, 4)]
    return mean_ssim(a, b, places, block_window(), 64 / 63)

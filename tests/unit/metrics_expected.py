#!/usr/bin/env python3
"""Where the numbers in metrics_expected_test.cpp come from: every metric once more, in NumPy and by another route.

Run by hand (needs NumPy): metrics_expected.py. It makes the pictures of tests/support/formula_images.h from the
same integer formulas, and prints each figure. The routes differ from engine/report on purpose: whole 2-D kernels and
explicit padding instead of separable passes, direct definitions instead of sums by blocks, everything in double.
"""
import numpy as np

SIZES = [(64, 48), (23, 17), (7, 5)]
PIXELS_PER_DEGREE = 0.7 * 3840 / 0.7 * np.pi / 180


def pictures(width, height):
    y, x, c = np.meshgrid(np.arange(height), np.arange(width), np.arange(3), indexing="ij")
    reference = ((x + y) // 5 * 7 + 31 * c + 29 * ((x // 8) * (y // 6))) % 61 / 64.0
    noise = (x * x + 3 * y * y + 5 * x * y + 17 * c) % 23 - 9
    bright = (y * width + x) % 97 == 96
    return reference + noise / 256.0 + 4.0 * bright, reference


def convolve(plane, kernel):
    """Correlation with a whole 2-D kernel; the border pixel continues outside."""
    ry, rx = kernel.shape[0] // 2, kernel.shape[1] // 2
    padded = np.pad(plane, ((ry, ry), (rx, rx)), mode="edge")
    out = np.zeros_like(plane)
    for j in range(kernel.shape[0]):
        for i in range(kernel.shape[1]):
            out += kernel[j, i] * padded[j:j + plane.shape[0], i:i + plane.shape[1]]
    return out


def gaussian_2d(sigma, radius):
    axis = np.arange(-radius, radius + 1)
    return np.exp(-(axis[:, None] ** 2 + axis[None, :] ** 2) / (2 * sigma * sigma)), axis


def ssim(test, reference):
    """Wang et al. 2004: windows inside the picture where there are any, else windows cut at its border."""
    def shown(picture):
        luminance = np.clip(picture @ np.array([0.2126, 0.7152, 0.0722]), 0, 1)
        return np.where(luminance <= 0.0031308, 12.92 * luminance, 1.055 * luminance ** (1 / 2.4) - 0.055)

    a, b = shown(test), shown(reference)
    window, _ = gaussian_2d(1.5, 5)
    height, width = a.shape
    values = np.zeros_like(a)
    for y in range(height):
        for x in range(width):
            ys, xs = slice(max(0, y - 5), y + 6), slice(max(0, x - 5), x + 6)
            w = window[max(0, 5 - y):5 + height - y, max(0, 5 - x):5 + width - x][:11, :11]
            w = w / w.sum()
            pa, pb = a[ys, xs], b[ys, xs]
            ma, mb = (w * pa).sum(), (w * pb).sum()
            va, vb = (w * (pa - ma) ** 2).sum(), (w * (pb - mb) ** 2).sum()
            cov = (w * (pa - ma) * (pb - mb)).sum()
            values[y, x] = ((2 * ma * mb + 1e-4) * (2 * cov + 9e-4)) / ((ma * ma + mb * mb + 1e-4) * (va + vb + 9e-4))
    inside = values[5:-5, 5:-5]
    return inside.mean() if inside.size else values.mean()


RGB_TO_XYZ = np.array([[10135552 / 24577794, 8788810 / 24577794, 4435075 / 24577794],
                       [2613072 / 12288897, 8788810 / 12288897, 887015 / 12288897],
                       [1425312 / 73733382, 8788810 / 73733382, 70074185 / 73733382]])
WHITE = RGB_TO_XYZ.sum(axis=1)


def hunt_lab(rgb):
    t = rgb @ RGB_TO_XYZ.T / WHITE
    f = np.where(t > (6 / 29) ** 3, np.cbrt(t), t / (3 * (6 / 29) ** 2) + 4 / 29)
    lightness = 116 * f[..., 1] - 16
    return np.stack([lightness, 0.01 * lightness * 500 * (f[..., 0] - f[..., 1]),
                     0.01 * lightness * 200 * (f[..., 1] - f[..., 2])], axis=-1)


def hyab(a, b):
    d = a - b
    return np.abs(d[..., 0]) + np.sqrt(d[..., 1] ** 2 + d[..., 2] ** 2)


def flip(test, reference, ppd=PIXELS_PER_DEGREE):
    """Andersson et al. 2020, LDR-FLIP of the linear pictures cut to [0, 1]."""
    sensitivities = [[(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]]
    radius = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi ** 2)) * ppd))
    degrees = np.arange(-radius, radius + 1) / ppd
    squared = degrees[:, None] ** 2 + degrees[None, :] ** 2

    def opponent(picture):
        t = np.clip(picture, 0, 1) @ RGB_TO_XYZ.T / WHITE
        return np.stack([116 * t[..., 1] - 16, 500 * (t[..., 0] - t[..., 1]), 200 * (t[..., 1] - t[..., 2])], axis=-1)

    def seen(picture):
        channels = []
        for c, terms in enumerate(sensitivities):
            kernel = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi ** 2 * squared / b) for a, b in terms)
            channels.append(convolve(opponent(picture)[..., c], kernel / kernel.sum()))
        y = (channels[0] + 16) / 116
        t = np.stack([y + channels[1] / 500, y, y - channels[2] / 200], axis=-1)
        rgb = np.linalg.solve(RGB_TO_XYZ, (t * WHITE).reshape(-1, 3).T).T.reshape(t.shape)
        return hunt_lab(np.clip(rgb, 0, 1))

    def features(picture):
        y = (opponent(picture)[..., 0] + 16) / 116
        sigma = 0.5 * 0.082 * ppd
        gauss, axis = gaussian_2d(sigma, int(np.ceil(3 * sigma)))
        lengths = []
        for kernel in (-axis[None, :] * gauss, (axis[None, :] ** 2 / sigma ** 2 - 1) * gauss):
            kernel = np.where(kernel > 0, kernel / kernel[kernel > 0].sum(), -kernel / kernel[kernel < 0].sum())
            lengths.append(np.sqrt(convolve(y, kernel) ** 2 + convolve(y, kernel.T) ** 2))
        return lengths

    largest = hyab(hunt_lab(np.array([0.0, 1, 0])), hunt_lab(np.array([0.0, 0, 1]))) ** 0.7
    color = hyab(seen(test), seen(reference)) ** 0.7
    split = 0.4 * largest
    color = np.where(color < split, 0.95 / split * color, 0.95 + (color - split) / (largest - split) * 0.05)
    feature = np.maximum(*(np.abs(t - r) for t, r in zip(features(test), features(reference))))
    return color ** (1 - np.sqrt(feature / np.sqrt(2)))


def hdr_flip(test, reference):
    """Andersson et al. 2021, with the tone curve of Narkowicz 2015."""
    numerator, denominator = np.poly1d([0.36 * 2.51, 0.018, 0]), np.poly1d([0.36 * 2.43, 0.354, 0.14])
    bright = max((numerator - 0.85 * denominator).roots.real)
    luminance = (reference @ np.array([0.2126, 0.7152, 0.0722])).ravel()
    start, stop = np.log2(bright / luminance.max()), np.log2(bright / np.median(luminance))
    worst = np.zeros(reference.shape[:2])
    for stops in np.linspace(start, stop, max(2, int(np.ceil(stop - start)))):
        shown = [np.clip(numerator(p) / denominator(p), 0, 1) for p in
                 (np.maximum(2 ** stops * test, 0), np.maximum(2 ** stops * reference, 0))]
        worst = np.maximum(worst, flip(*shown))
    return worst


def picture_error(test, reference):
    """engine/render/picture_error.h; of the pixels that are left out, one may be so in part."""
    luminance = np.array([0.2126, 0.7152, 0.0722])
    t, r = (test @ luminance).ravel(), (reference @ luminance).ravel()
    padded = np.pad((reference @ luminance), 1, constant_values=np.nan)
    height, width = reference.shape[:2]
    around = np.nanmean([padded[j:j + height, i:i + width] for j in range(3) for i in range(3)], axis=0).ravel()
    dark = 0.1 * np.sqrt(r).mean() ** 2
    shares = np.sort(np.minimum(1, (t - r) ** 2 / (around ** 2 + dark ** 2)))
    kept = 0.999 * shares.size
    weights = np.clip(kept - np.arange(shares.size), 0, 1)
    return np.sqrt((weights * shares).sum() / kept)


def all_metrics(test, reference):
    error = test - reference
    relative = (error ** 2 / (reference ** 2 + 0.01)).mean(axis=2).ravel()
    kept = relative.size - relative.size // 1000
    return {"mse": (error ** 2).mean(), "rmse": np.sqrt((error ** 2).mean()), "relMse": relative.mean(),
            "relMseTrimmed": np.sort(relative)[:kept].mean(), "mape": (np.abs(error) / (np.abs(reference) + 0.01)).mean(),
            "bias": error.mean(), "relativeBias": error.mean() / reference.mean(), "maxError": np.abs(error).max(),
            "ssim": ssim(test, reference), "flip": flip(test, reference).mean(),
            "hdrFlip": hdr_flip(test, reference).mean(), "pictureError": picture_error(test, reference)}


if __name__ == "__main__":
    for size in SIZES:
        figures = all_metrics(*pictures(*size))
        print(f"{{{size[0]}, {size[1]}, " + ", ".join(f"{value:.12g}" for value in figures.values()) + "},")
    print("names:", ", ".join(figures))
    test, reference = pictures(64, 48)
    print(f"flip at +1 stop, 20 pixels per degree: {flip(2 * test, 2 * reference, 20).mean():.12g}")
    print(f"ssim at +1 stop: {ssim(2 * test, 2 * reference):.12g}")
    print(f"hdr flip of 1024 times the sixth powers: {hdr_flip(1024 * test ** 6, 1024 * reference ** 6).mean():.12g}")

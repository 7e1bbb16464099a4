// Pictures that follow from integer formulas, so that another program can make the same ones bit by
// bit (tests/unit/metrics_expected.py).
#pragma once

#include <cstdint>

#include "engine/io/exr_io.h"

namespace glint::test {

inline ImageF flatImage(int width, int height, float value) {
    const size_t count = 3 * static_cast<size_t>(width) * static_cast<size_t>(height);
    return {.width = width, .height = height, .rgb = std::vector<float>(count, value)};
}

/// Steps along a diagonal, broken by blocks: ((x + y) / 5 * 7 + 31 c + 29 (x / 8) (y / 6)) mod 61, in
/// sixty-fourths, whole divisions. Exact in float.
inline ImageF formulaReference(int width, int height) {
    ImageF image = flatImage(width, height, 0.0f);
    for (int i = 0; i < 3 * width * height; ++i) {
        const int c = i % 3, x = i / 3 % width, y = i / 3 / width;
        const int block = (x / 8) * (y / 6);
        image.rgb[static_cast<size_t>(i)] =
            static_cast<float>(((x + y) / 5 * 7 + 31 * c + 29 * block) % 61) / 64.0f;
    }
    return image;
}

/// The reference plus ((x^2 + 3 y^2 + 5 x y + 17 c) mod 23 - 9) / 256: noise with a bias. A few values are
/// negative, and every 97th pixel is 4 brighter, beyond what a screen shows.
inline ImageF formulaTest(int width, int height) {
    ImageF image = formulaReference(width, height);
    for (int i = 0; i < 3 * width * height; ++i) {
        const int c = i % 3, x = i / 3 % width, y = i / 3 / width;
        const int noise = (x * x + 3 * y * y + 5 * x * y + 17 * c) % 23 - 9;
        image.rgb[static_cast<size_t>(i)] +=
            static_cast<float>(noise) / 256.0f + ((i / 3) % 97 == 96 ? 4.0f : 0.0f);
    }
    return image;
}

/// R, G and B of the image as 32-bit floats.
inline ExrImage exrOf(const ImageF& image) {
    ExrImage exr{.width = image.width, .height = image.height, .channels = {}, .attributes = {}};
    for (const char* channel : {"R", "G", "B"}) {
        exr.channels.push_back({.name = channel, .type = ExrPixelType::Float, .floats = {}, .ids = {}});
    }
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        exr.channels[i % 3].floats.push_back(image.rgb[i]);
    }
    return exr;
}

}  // namespace glint::test

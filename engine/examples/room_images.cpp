// The living room's images: wood, cloth, leather, the rug, pictures, and the view from the window.
#include <array>

#include "engine/examples/living_room.h"
#include "engine/examples/paint.h"

namespace glint::examples {
namespace {

/// Grain along u, with rings that a saw cut.
Vec3d grain(const Noise& noise, double u, double v, const Vec3d& dark, const Vec3d& light) {
    const double ring = noise.cloud(u, v, 2, 9, 4), fibre = noise.cloud(u, v, 10, 180, 3);
    return mix(dark, light, 0.5 * (0.5 + 0.5 * std::sin(44.0 * ring)) + 0.5 * fibre);
}

void paintWoods(ExampleFolder* folder) {
    const Noise noise(51);
    constexpr Masonry kPlanks{2, 8, 0.0012, 0.008};
    folder->image("planks.png", paint(1024, 1024, [&](double u, double v) {
                      const Masonry::Place place = kPlanks.at(u, v);
                      const double shift = noise.cell(place.column, place.row);
                      const Vec3d wood =
                          grain(noise, u + shift, v + 7.0 * shift, {0.44, 0.29, 0.17}, {0.66, 0.48, 0.31});
                      return mix(Vec3d(0.1, 0.06, 0.035), wood * (0.8 + 0.35 * shift), place.stone);
                  }));
    folder->image("planks_height.png", paintHeights(1024, 1024, [&](double u, double v) {
                      const Masonry::Place place = kPlanks.at(u, v);
                      const double shift = noise.cell(place.column, place.row);
                      return place.stone * 0.8 + 0.2 * noise.cloud(u + shift, v + 7.0 * shift, 10, 180, 3);
                  }));
    folder->image("oak.png", paint(1024, 512, [&](double u, double v) {
                      return grain(noise, u, v, {0.42, 0.27, 0.15}, {0.66, 0.48, 0.30});
                  }));
    folder->image("walnut.png", paint(1024, 512, [&](double u, double v) {
                      return grain(noise, u + 0.4, v, {0.22, 0.12, 0.07}, {0.42, 0.26, 0.16});
                  }));
    folder->image("marble.png", paint(1024, 512, [&](double u, double v) {
                      const double bend = noise.cloud(u, v, 4, 2, 5);
                      const double cross = noise.cloud(u + 0.4 * bend, v + 0.3 * bend, 4, 2, 5) - 0.5;
                      const double line = 1.0 - ramp(0.0, 0.06, std::abs(cross));
                      return mix(mix(Vec3d(0.86, 0.85, 0.83), Vec3d(0.95, 0.94, 0.92), bend),
                                 Vec3d(0.5, 0.5, 0.52), 0.6 * line * bend);
                  }));
}

void paintCloth(ExampleFolder* folder) {
    const Noise noise(57);
    // Threads over and under each other, 16 of each in a tile.
    const auto weave = [&](double u, double v) {
        const double a = fraction(16.0 * u), b = fraction(16.0 * v);
        const bool isOver = (static_cast<int>(16.0 * u) + static_cast<int>(16.0 * v)) % 2 == 0;
        const double warp = std::sin(kPiD * a), weft = std::sin(kPiD * b);
        return (isOver ? warp : weft) * (0.8 + 0.2 * noise.cloud(u, v, 16, 16, 2));
    };
    folder->image("weave_height.png", paintHeights(512, 512, weave));
    folder->image("linen.png", paint(512, 512, [&](double u, double v) {
                      const double tone =
                          0.86 + 0.14 * weave(u, v) + 0.1 * (noise.cloud(u, v, 16, 64, 2) - 0.5);
                      return Vec3d(0.60, 0.61, 0.58) * tone;
                  }));
    folder->image("curtain.png", paint(512, 512, [&](double u, double v) {
                      const double tone = 0.9 + 0.2 * (noise.cloud(u, v, 96, 24, 3) - 0.5);
                      return Vec3d(0.44, 0.56, 0.56) * tone;
                  }));
    folder->image(
        "pillow.png", paint(512, 512, [&](double u, double v) {
            const double a = std::abs(fraction(4.0 * u) - 0.5), b = std::abs(fraction(4.0 * v) - 0.5);
            const bool isLine = std::abs(a + b - 0.5) < 0.05 || a + b < 0.14;
            return (isLine ? Vec3d(0.86, 0.80, 0.66) : Vec3d(0.09, 0.24, 0.30)) * (0.9 + 0.1 * weave(u, v));
        }));
    folder->image("leather_height.png", paintHeights(512, 512, [&](double u, double v) {
                      const double fold = std::abs(noise.cloud(u, v, 24, 24, 3) - 0.5);
                      return 0.7 * ramp(0.0, 0.12, fold) + 0.3 * noise.cloud(u, v, 6, 6, 3);
                  }));
    folder->image("plaster_height.png",
                  paintHeights(512, 512, [&](double u, double v) { return noise.cloud(u, v, 12, 12, 5); }));
}

/// A rug in the manner of the Caucasus: a field with a medallion, borders of stars and hooks.
Vec3d rugColor(const Noise& noise, double u, double v) {
    const Vec3d red(0.60, 0.16, 0.13), blue(0.13, 0.20, 0.36), cream(0.80, 0.72, 0.56),
        gold(0.72, 0.48, 0.18), teal(0.14, 0.34, 0.34);
    const double x = (u - 0.5) * 2.9, y = (v - 0.5) * 2.0;
    const double inset = std::min(1.45 - std::abs(x), 1.0 - std::abs(y));
    // Knots are square: patterns have steps.
    const auto step = [](double d) { return std::floor(d / 0.02) * 0.02; };
    const double sx = step(std::abs(x)), sy = step(std::abs(y));
    Vec3d color = red;
    if (inset < 0.05) {
        color = blue;
    } else if (inset < 0.075 || (inset > 0.255 && inset < 0.28)) {
        color = cream;
    } else if (inset < 0.255) {
        const double along = std::abs(x) > std::abs(y) + 0.45 ? y : x, across = inset - 0.165;
        const double a = std::abs(fraction(along / 0.2) - 0.5) * 0.2, b = std::abs(across);
        const double star = step(a) + step(b);
        color = star < 0.03 ? red : star < 0.07 ? gold : std::abs(a - 0.1) < 0.012 ? teal : blue;
    } else {
        const double medallion = sx / 1.05 + sy / 0.62;
        const double small = std::abs(fraction(x / 0.24) - 0.5) + std::abs(fraction(y / 0.24) - 0.5);
        if (medallion < 1.0) { color = blue; }
        if (medallion < 0.94) { color = gold; }
        if (medallion < 0.88) { color = cream; }
        if (medallion < 0.62) { color = teal; }
        if (medallion < 0.56) { color = red; }
        if (medallion < 0.26) { color = gold; }
        if (medallion < 0.18) { color = blue; }
        if (medallion > 1.05 && small < 0.22) { color = small < 0.1 ? cream : blue; }
        if (medallion > 0.66 && medallion < 0.84 && small < 0.2) { color = red; }
    }
    return color * (0.85 + 0.3 * noise.cloud(u, v, 160, 110, 2));
}

/// Hills behind each other, paler the farther they are, under an evening sky; `warmth` of the light at
/// the horizon.
Vec3d landscape(const Noise& noise, double u, double v, const Vec3d& high, const Vec3d& low,
                const Vec3d& near) {
    const double cloud = noise.cloud(u, 3.0 * v, 3, 3, 5);
    Vec3d color = mix(low, high, ramp(0.35, 1.0, v));
    color = mix(color, mix(low, Vec3d(1.0), 0.5), 0.55 * ramp(0.52, 0.75, cloud) * ramp(0.35, 0.5, v));
    for (int hill = 0; hill < 5; ++hill) {
        const double ridge =
            0.46 - 0.085 * hill + 0.1 * (noise.cloud(u + 0.17 * hill, 0.1 * hill, 3 + hill, 4, 4) - 0.5);
        if (v < ridge) {
            color = mix(low, near, 0.25 + 0.17 * hill) * (0.9 + 0.2 * noise.cloud(u, v, 30, 30, 3));
        }
    }
    return color;
}

void paintImages(ExampleFolder* folder) {
    const Noise noise(71);
    folder->image("rug.png", paint(1024, 704, [&](double u, double v) { return rugColor(noise, u, v); }));
    folder->image("painting.png", paint(1024, 640, [&](double u, double v) {
                      // Strokes: a patch takes the colour of a place nearby.
                      const double su = u + 0.015 * (noise.cloud(u, v, 60, 30, 2) - 0.5),
                                   sv = v + 0.02 * (noise.cloud(v, u, 60, 30, 2) - 0.5);
                      Vec3d color = landscape(noise, su, sv, {0.25, 0.42, 0.62}, {0.96, 0.76, 0.48},
                                              {0.12, 0.20, 0.16});
                      const double du = (su - 0.68) * 1.6, dv = sv - 0.56;
                      if (du * du + dv * dv < 0.0045) { color = Vec3d(1.0, 0.9, 0.66); }
                      return color * (0.92 + 0.16 * noise.cloud(u, v, 200, 60, 2));
                  }));
    folder->image("sketch.png", paint(384, 512, [&](double u, double v) {
                      const double x = std::abs(u - 0.5), y = std::abs(v - 0.5);
                      if (x > 0.36 || y > 0.38) { return Vec3d(0.92, 0.90, 0.85); }
                      const double a = std::sqrt((u - 0.42) * (u - 0.42) + (v - 0.58) * (v - 0.58));
                      const double b = std::sqrt((u - 0.6) * (u - 0.6) + (v - 0.4) * (v - 0.4));
                      if (a < 0.17) { return Vec3d(0.78, 0.32, 0.16); }
                      if (b < 0.13) { return Vec3d(0.12, 0.28, 0.36); }
                      if (std::abs(u - v) < 0.012) { return Vec3d(0.1); }
                      return Vec3d(0.88, 0.80, 0.64);
                  }));
    folder->image("photo.png", paint(512, 416, [&](double u, double v) {
                      if (std::abs(u - 0.5) > 0.4 || std::abs(v - 0.5) > 0.38) {
                          return Vec3d(0.94, 0.93, 0.90);
                      }
                      const Vec3d color = landscape(noise, u + 0.3, v, {0.62, 0.64, 0.66}, {0.9, 0.88, 0.85},
                                                    {0.08, 0.08, 0.09});
                      return Vec3d((color.x + color.y + color.z) / 3.0);
                  }));
    folder->image("view.png", paint(512, 384, [&](double u, double v) {
                      return landscape(noise, u, 0.8 * v + 0.12, {0.20, 0.36, 0.74}, {0.56, 0.68, 0.90},
                                       {0.06, 0.12, 0.14});
                  }));
    folder->image(
        "porcelain.png", paint(512, 512, [&](double u, double v) {
            const double a = fraction(6.0 * u) - 0.5, b = fraction(6.0 * v) - 0.5;
            const double petals = 0.24 + 0.1 * std::cos(6.0 * std::atan2(b, a));
            const double radius = std::sqrt(a * a + b * b);
            const bool isBlue =
                (radius < petals && radius > 0.09) || std::abs(std::abs(a) + std::abs(b) - 0.5) < 0.03;
            return isBlue ? mix(Vec3d(0.10, 0.17, 0.45), Vec3d(0.2, 0.3, 0.6), noise.cloud(u, v, 20, 20, 3))
                          : Vec3d(0.92, 0.92, 0.90);
        }));
    folder->image("leaf.png", paint(256, 256, [&](double u, double v) {
                      const double a = std::abs(2.0 * u - 1.0);
                      const double vein = std::abs(fraction(9.0 * (v - 0.35 * a)) - 0.5);
                      const bool isVein = a < 0.05 || vein > 0.47;
                      return (isVein ? Vec3d(0.42, 0.55, 0.26) : Vec3d(0.13, 0.32, 0.12)) *
                             (0.85 + 0.3 * noise.cloud(u, v, 8, 8, 4));
                  }));
}

}  // namespace

void paintLivingRoom(ExampleFolder* folder) {
    paintWoods(folder);
    paintCloth(folder);
    paintImages(folder);
}

}  // namespace glint::examples

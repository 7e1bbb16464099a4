// The cathedral's images: stone, marble, wood, carpet and stained glass.
#include <array>

#include "engine/examples/cathedral.h"
#include "engine/examples/paint.h"

namespace glint::examples {
namespace {

constexpr std::array<Vec3d, 6> kGlassColors{Vec3d(0.10, 0.20, 0.72), Vec3d(0.75, 0.08, 0.10),
                                            Vec3d(0.98, 0.72, 0.18), Vec3d(0.10, 0.52, 0.42),
                                            Vec3d(0.16, 0.38, 0.85), Vec3d(0.50, 0.14, 0.52)};
const Vec3d kLead(0.015);

constexpr Masonry kAshlar{4, 8, 0.008, 0.012};

Vec3d limestone(const Noise& noise, double u, double v, double tint) {
    const double stain = noise.cloud(u, v, 3, 3, 5), grain = noise.cloud(u, v, 90, 90, 2);
    const Vec3d stone = mix(Vec3d(0.72, 0.67, 0.58), Vec3d(0.84, 0.80, 0.73), stain);
    return stone * (0.93 + 0.08 * tint + 0.07 * (grain - 0.5));
}

void paintStone(ExampleFolder* folder) {
    const Noise noise(11);
    folder->image("limestone.png",
                  paint(1024, 1024, [&](double u, double v) { return limestone(noise, u, v, 0.5); }));
    folder->image("ashlar.png", paint(1024, 1024, [&](double u, double v) {
                      const Masonry::Place place = kAshlar.at(u, v);
                      const Vec3d stone = limestone(noise, u, v, noise.cell(place.column, 100 + place.row));
                      return mix(Vec3d(0.52, 0.47, 0.40), stone, place.stone);
                  }));
    folder->image("ashlar_height.png", paintHeights(1024, 1024, [&](double u, double v) {
                      const Masonry::Place place = kAshlar.at(u, v);
                      const double face = 0.72 + 0.12 * noise.cell(place.column, place.row);
                      return place.stone * face + 0.16 * noise.cloud(u, v, 24, 24, 5);
                  }));
    folder->image("chisel_height.png",
                  paintHeights(512, 512, [&](double u, double v) { return noise.cloud(u, v, 8, 8, 6); }));
}

/// Veins are where a cloud crosses its middle.
double vein(const Noise& noise, double u, double v, int cells) {
    const double bend = noise.cloud(u, v, cells, cells, 4);
    return 1.0 -
           ramp(0.0, 0.045, std::abs(noise.cloud(u + 0.3 * bend, v + 0.2 * bend, cells, cells, 4) - 0.5));
}

void paintFloor(ExampleFolder* folder) {
    const Noise noise(23);
    constexpr int kTiles = 4;
    const auto joint = [](double u, double v) {
        const double fu = fraction(u * kTiles), fv = fraction(v * kTiles);
        return ramp(0.006, 0.016, std::min(std::min(fu, 1.0 - fu), std::min(fv, 1.0 - fv)));
    };
    folder->image("marble.png", paint(1024, 1024, [&](double u, double v) {
                      const int column = static_cast<int>(u * kTiles), row = static_cast<int>(v * kTiles);
                      const double shift = noise.cell(column, row);  // each slab was cut from elsewhere
                      const double su = u + shift, sv = v + 3.0 * shift;
                      const double cloud = noise.cloud(su, sv, 6, 6, 5), line = vein(noise, su, sv, 4);
                      const bool isLight = (column + row) % 2 == 0;
                      const Vec3d light = mix(Vec3d(0.80, 0.75, 0.66), Vec3d(0.90, 0.87, 0.80), cloud);
                      const Vec3d dark = mix(Vec3d(0.24, 0.12, 0.10), Vec3d(0.36, 0.19, 0.15), cloud);
                      const Vec3d slab = isLight ? mix(light, Vec3d(0.58, 0.52, 0.46), 0.55 * line)
                                                 : mix(dark, Vec3d(0.62, 0.48, 0.42), 0.45 * line);
                      return mix(Vec3d(0.22, 0.20, 0.18), slab * (0.92 + 0.12 * shift), joint(u, v));
                  }));
    folder->image("marble_height.png", paintHeights(1024, 1024, [&](double u, double v) {
                      // Worn slabs are not quite level.
                      return 0.8 * joint(u, v) + 0.2 * noise.cloud(u, v, 6, 6, 3);
                  }));
}

void paintWoodAndCarpet(ExampleFolder* folder) {
    const Noise noise(31);
    folder->image("wood.png", paint(1024, 512, [&](double u, double v) {
                      const double ring = noise.cloud(u, v, 3, 12, 4);
                      const double fibre = noise.cloud(u, v, 12, 200, 3);
                      const double line = 0.5 + 0.5 * std::sin(60.0 * ring);
                      return mix(Vec3d(0.33, 0.19, 0.10), Vec3d(0.56, 0.36, 0.20),
                                 0.55 * line + 0.45 * fibre);
                  }));
    folder->image("carpet.png", paint(512, 512, [&](double u, double v) {
                      const double x = std::abs(2.0 * u - 1.0);  // from the middle to the edge
                      const Vec3d red(0.50, 0.05, 0.07), gold(0.78, 0.58, 0.22), deep(0.28, 0.02, 0.06);
                      const double thread = 0.86 + 0.28 * (noise.cloud(u, v, 128, 128, 2) - 0.5);
                      const double a = fraction(4.0 * v) - 0.5, b = (x - 0.81) / 0.11;
                      Vec3d color = red;
                      if (x > 0.68) { color = std::abs(a) * 2.0 + std::abs(b) < 0.8 ? gold : deep; }
                      if (x > 0.94 || (x > 0.66 && x < 0.69)) { color = gold; }
                      const double diamond = std::abs(fraction(2.0 * v) - 0.5) * 1.2 + x;
                      if (x < 0.6 && diamond > 0.42 && diamond < 0.47) { color = gold; }
                      return color * thread;
                  }));
}

/// One pane's colour: brighter and darker where the glass is thin and thick.
Vec3d pane(const Noise& noise, size_t color, double u, double v) {
    const double thickness = noise.cloud(u, v, 16, 16, 4);
    return kGlassColors[color % kGlassColors.size()] * (0.65 + 0.6 * thickness);
}

void paintLancet(ExampleFolder* folder) {
    const Noise noise(41);
    folder->image("lancet.png", paint(512, 1024, [&](double u, double v) {
                      const double x = std::abs(2.0 * u - 1.0);
                      const double y = fraction(v * 4.0);  // one of four medallions
                      const double px = x * 1.0, py = std::abs(2.0 * y - 1.0);
                      const double radius = std::sqrt(px * px + py * py);
                      const double petal = std::atan2(py, px) / (kPiD / 4.0);
                      const bool isLead =
                          std::abs(x - 0.86) < 0.012 || std::abs(radius - 0.72) < 0.014 ||
                          std::abs(radius - 0.34) < 0.014 ||
                          (x < 0.86 && radius > 0.34 && std::abs(fraction(petal) - 0.5) > 0.485) ||
                          (x > 0.86 && fraction(v * 24.0) < 0.05);
                      if (isLead) { return kLead; }
                      const auto medallion = static_cast<size_t>(v * 4.0);
                      if (x > 0.86) {
                          return pane(noise, static_cast<size_t>(v * 24.0) % 2 == 0 ? 2 : 1, u, v);
                      }
                      if (radius < 0.34) { return pane(noise, medallion % 2 == 0 ? 2 : 1, u, v); }
                      if (radius < 0.72) { return pane(noise, static_cast<size_t>(petal) + medallion, u, v); }
                      return pane(noise, 0, u, v);
                  }));
}

void paintRose(ExampleFolder* folder) {
    const Noise noise(43);
    folder->image("rose.png", paint(1024, 1024, [&](double u, double v) {
                      const double x = 2.0 * u - 1.0, y = 2.0 * v - 1.0;
                      const double radius = std::sqrt(x * x + y * y);
                      const double angle = (std::atan2(y, x) / kPiD + 1.0) * 6.0;  // twelve petals
                      const double ring = radius * 9.0;
                      const int band = static_cast<int>(ring);
                      const double spokes = angle * (band < 3 ? 1.0 : band < 6 ? 2.0 : 4.0) + 0.5 * band;
                      const double widthOfSpoke = 0.02 * (band < 3 ? 1.0 : 1.6);
                      if (std::abs(fraction(ring) - 0.5) > 0.46 ||
                          std::abs(fraction(spokes) - 0.5) > 0.5 - widthOfSpoke) {
                          return kLead;
                      }
                      constexpr std::array<size_t, 10> kBands{2, 1, 0, 4, 1, 0, 4, 2, 0, 0};
                      const bool isOdd = static_cast<int>(spokes) % 2 != 0;
                      const size_t color = kBands[static_cast<size_t>(band) % kBands.size()];
                      return pane(noise, isOdd && band > 2 ? color + 3 : color, u, v);
                  }));
}

}  // namespace

void paintCathedral(ExampleFolder* folder) {
    paintStone(folder);
    paintFloor(folder);
    paintWoodAndCarpet(folder);
    paintLancet(folder);
    paintRose(folder);
}

}  // namespace glint::examples

// Skies with one bright pixel: the whole light of a scene in a few thousandths of a steradian, or at the
// horizon, or in the pole's row.
//
// The truth is the irradiance of a level plane by quadrature in double over the image as it is interpolated.
#include <cmath>
#include <memory>

#include "engine/stress/stress_families.h"
#include "engine/stress/stress_render.h"
#include "engine/stress/stress_scene.h"

namespace glint {
namespace {

constexpr int kWidth = 64;
constexpr int kHeight = 32;

/// The integral of row y's hat function times cos sin over the polar angle's upper half; the outermost row
/// reaches to the pole.
double rowWeight(int y) {
    constexpr int kStepsAcross = 20000;
    double sum = 0.0;
    for (int i = 0; i < kStepsAcross; ++i) {
        const double theta = (i + 0.5) * 0.5 * kPiD / kStepsAcross;
        const double row = std::max(0.0, theta / kPiD * kHeight - 0.5);
        const double weight = std::max(0.0, 1.0 - std::abs(row - y));
        sum += weight * std::cos(theta) * std::sin(theta);
    }
    return sum * 0.5 * kPiD / kStepsAcross;
}

double irradiance(const ImageF& image) {
    double sum = 0.0;
    for (int y = 0; y < kHeight; ++y) {
        double row = 0.0;
        for (int x = 0; x < kWidth; ++x) {
            row += static_cast<double>(image.rgb[static_cast<size_t>(3 * (y * kWidth + x))]);
        }
        if (row > 0.0) { sum += row * rowWeight(y); }
    }
    return sum * 2.0 * kPiD / kWidth;
}

std::shared_ptr<const ImageF> brightPixel(float sky, float pixel, int row) {
    auto image = std::make_shared<ImageF>();
    image->width = kWidth;
    image->height = kHeight;
    image->rgb.assign(static_cast<size_t>(3 * kWidth * kHeight), sky);
    for (int channel = 0; channel < 3; ++channel) {
        image->rgb[static_cast<size_t>(3 * (row * kWidth + 17) + channel)] = pixel;
    }
    return image;
}

StressCase pixelCase(float pixel, int row, const char* where) {
    StressCase c;
    c.family = "environment";
    c.grade = "pixel " + gradeNumber(pixel) + " " + where;
    c.extreme = "one pixel of " + gradeNumber(pixel) + " " + where + " in a sky of 0.01";
    c.truth = "irradiance by quadrature in double";
    c.run = [=](const StressEffort& effort) {
        SceneDescription scene = emptyStressScene({0.3f, 1, 0.2f}, {0, 0, 0}, 5.0f);
        scene.options.maxDepth = 1;
        scene.environment.color = Vec3(1.0f);
        scene.environment.image = 0;
        scene.environment.rotationDeg = 33.0f;
        scene.environmentImages.emplace_back();
        const auto image = brightPixel(0.01f, pixel, row);
        scene.environmentImages.back().floats = image;
        addObject(&scene, ShapeKind::Plane, placeFlatShape({0, 0, 0}, {0, 1, 0}, 1, 1),
                  diffuseMaterial(0.5f));
        return measurePaths(scene, effort.passes(1024, 192), 0.5 / kPiD * irradiance(*image), effort);
    };
    return c;
}

}  // namespace

void addEnvironmentCases(StressCases* cases) {
    for (const float pixel : {1.0f, 1e3f, 1e6f, 1e9f, 1e18f, 1e30f}) {
        cases->push_back(pixelCase(pixel, 0, "overhead"));
        cases->push_back(pixelCase(pixel, 8, "half way up"));
        cases->push_back(pixelCase(pixel, 15, "at the horizon"));
    }
}

}  // namespace glint

#include "engine/io/environment_image.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <ImfEnvmap.h>
#include <fmt/format.h>

#include "engine/io/cube_map.h"
#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"

namespace glint {
namespace {

/// What the sun's radiance stays below in any unit, and sums over a map stay finite.
constexpr float kLargestLight = 1e12f;

bool isCubeMap(const ImageF& image) { return image.width > 1 && image.height == 6 * int64_t{image.width}; }

/// As OpenEXR's maps have it: y points up, and the middle of a map along +z.
Imath::V3f directionOf(double latitude, double longitude) {
    return {static_cast<float>(std::sin(longitude) * std::cos(latitude)),
            static_cast<float>(std::sin(latitude)),
            static_cast<float>(std::cos(longitude) * std::cos(latitude))};
}

/// The cube map's colour where a ray of that direction meets it, interpolated within the face.
void lookUp(const ImageF& cube, const Imath::V3f& direction, float* rgb) {
    const Imath::Box2i window({0, 0}, {cube.width - 1, cube.height - 1});
    Imf::CubeMapFace face{};
    Imath::V2f inFace;
    Imf::CubeMap::faceAndPixelPosition(direction, window, face, inFace);
    const Imath::V2f place = Imf::CubeMap::pixelPosition(face, window, inFace);
    const int top = static_cast<int>(face) * cube.width;
    const float left = std::clamp(std::floor(place.x), 0.0f, static_cast<float>(cube.width - 2));
    const float above =
        std::clamp(std::floor(place.y - static_cast<float>(top)), 0.0f, static_cast<float>(cube.width - 2));
    const float u = std::clamp(place.x - left, 0.0f, 1.0f);
    const float v = std::clamp(place.y - static_cast<float>(top) - above, 0.0f, 1.0f);
    const size_t row = 3 * static_cast<size_t>(cube.width);
    const float* first = &cube.rgb[(static_cast<size_t>(top) + static_cast<size_t>(above)) * row +
                                   3 * static_cast<size_t>(left)];
    for (size_t c = 0; c < 3; ++c) {
        rgb[c] = (1.0f - v) * ((1.0f - u) * first[c] + u * first[c + 3]) +
                 v * ((1.0f - u) * first[c + row] + u * first[c + row + 3]);
    }
}

std::shared_ptr<ImageF> latitudeLongitude(const ImageF& cube) {
    auto map = std::make_shared<ImageF>(ImageF{4 * cube.width, 2 * cube.width, {}});
    map->rgb.resize(size_t{3} * static_cast<size_t>(map->width) * static_cast<size_t>(map->height));
    constexpr double kPiDouble = std::numbers::pi;
    for (int y = 0; y < map->height; ++y) {
        const double latitude = kPiDouble * (0.5 - (y + 0.5) / map->height);
        for (int x = 0; x < map->width; ++x) {
            const double longitude = kPiDouble * (1.0 - 2.0 * (x + 0.5) / map->width);
            const size_t pixel =
                static_cast<size_t>(y) * static_cast<size_t>(map->width) + static_cast<size_t>(x);
            lookUp(cube, directionOf(latitude, longitude), &map->rgb[3 * pixel]);
        }
    }
    return map;
}

struct WrongValues {
    size_t negative = 0, infinite = 0, tooLarge = 0, notNumbers = 0;
    size_t first = 0;  ///< index of the first wrong value
    float largest = kLargestHalf;

    size_t count() const { return negative + infinite + tooLarge + notNumbers; }
};

WrongValues findWrongValues(const ImageF& image) {
    WrongValues wrong;
    for (size_t i = 0; i < image.rgb.size(); ++i) {
        const float value = image.rgb[i];
        if (value >= 0.0f && value <= kLargestLight) {
            wrong.largest = std::max(wrong.largest, value);
            continue;
        }
        if (wrong.count() == 0) { wrong.first = i; }
        wrong.notNumbers += std::isnan(value) ? 1 : 0;
        wrong.infinite += std::isinf(value) && value > 0.0f ? 1 : 0;
        wrong.tooLarge += std::isfinite(value) && value > kLargestLight ? 1 : 0;
        wrong.negative += value < 0.0f ? 1 : 0;
    }
    return wrong;
}

/// Within what rounding and a few lost rows make of it.
bool isTwiceAsWide(const auto& image) {
    return std::abs(image.width - 2 * image.height) <= 1 + image.height / 50;
}

/// By its sides: a column, a strip or a cross of squares.
bool canBeCubeMap(const Image8& image) {
    const int64_t width = image.width, height = image.height;
    return height == 6 * width || width == 6 * height || 3 * width == 4 * height || 4 * width == 3 * height;
}

std::string warningOfSides(const auto& image, const std::string& name) {
    return fmt::format(
        "{}: a picture of {} x {} pixels as light from everywhere is read as a map of latitude "
        "and longitude; "
        "expected one twice as wide as high, or a cube map: a column, a strip or a cross",
        name, image.width, image.height);
}

SceneImage withoutAlpha(const SceneImage& image) {
    const Image8& pixels = *image.bytes;
    if (pixels.alpha.empty()) { return {.bytes = image.bytes}; }
    return {.bytes = std::make_shared<Image8>(Image8{pixels.width, pixels.height, pixels.rgb})};
}

std::string warningOf(const WrongValues& wrong, const ImageF& image, const std::string& name) {
    std::string kinds;
    const auto add = [&kinds](size_t count, std::string_view what) {
        if (count > 0) { kinds += fmt::format("{}{} {}", kinds.empty() ? "" : ", ", count, what); }
    };
    add(wrong.negative, "below 0, taken for 0");
    add(wrong.notNumbers, "not a number, taken for 0");
    add(wrong.infinite, fmt::format("infinite, taken for {:g}", wrong.largest));
    add(wrong.tooLarge, fmt::format("above {:g}, taken for {:g}", kLargestLight, wrong.largest));
    const size_t pixel = wrong.first / 3;
    const auto width = static_cast<size_t>(image.width);
    return fmt::format("{}: {} of its {} values cannot be light ({}), the first in column {}, row {}", name,
                       wrong.count(), image.rgb.size(), kinds, pixel % width, pixel / width);
}

}  // namespace

SceneImage environmentImage(const SceneImage& image, const std::string& name,
                            std::vector<std::string>* warnings) {
    const Image8* bytes = image.bytes.get();
    if (bytes != nullptr && isTwiceAsWide(*bytes)) { return withoutAlpha(image); }
    if (bytes != nullptr && !canBeCubeMap(*bytes)) {
        warnings->push_back(warningOfSides(*bytes, name));
        return withoutAlpha(image);
    }
    std::shared_ptr<const ImageF> map = linearColors(image);
    if (const WrongValues wrong = findWrongValues(*map); wrong.count() > 0) {
        warnings->push_back(warningOf(wrong, *map, name));
        auto repaired = std::make_shared<ImageF>(*map);
        for (float& value : repaired->rgb) {
            value = value > wrong.largest ? wrong.largest : (value >= 0.0f ? value : 0.0f);
        }
        map = std::move(repaired);
    }
    if (isCubeMap(*map)) { return {.floats = latitudeLongitude(*map)}; }
    if (isTwiceAsWide(*map)) { return {.floats = map}; }
    if (const std::vector<SceneImage> faces = facesOf(*map); !faces.empty()) {
        return {.floats = latitudeLongitude(*cubeColumn(faces).floats)};
    }
    warnings->push_back(warningOfSides(*map, name));
    return image.bytes ? withoutAlpha(image) : SceneImage{.floats = map};
}

}  // namespace glint

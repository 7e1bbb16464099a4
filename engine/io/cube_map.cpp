#include "engine/io/cube_map.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <ImfEnvmap.h>

#include "engine/math/vec.h"

namespace glint {
namespace {

/// A place of one of Direct3D's faces: from its left and its top, in [0, 1].
struct FacePlace {
    size_t face;
    float s, t;
};

/// Direct3D's axes are left-handed, with y upwards.
FacePlace placeIn(const Imath::V3f& d) {
    const float ax = std::fabs(d.x), ay = std::fabs(d.y), az = std::fabs(d.z);
    const auto at = [](size_t face, float s, float t, float axis) {
        return FacePlace{face, 0.5f * (s / axis + 1.0f), 0.5f * (t / axis + 1.0f)};
    };
    if (ax >= ay && ax >= az) { return d.x > 0.0f ? at(0, -d.z, -d.y, ax) : at(1, d.z, -d.y, ax); }
    if (ay >= az) { return d.y > 0.0f ? at(2, d.x, d.z, ay) : at(3, d.x, -d.z, ay); }
    return d.z > 0.0f ? at(4, d.x, -d.y, az) : at(5, -d.x, -d.y, az);
}

/// Imf has places within faces, which lie turned among the pixels.
template <class Value>
void turn(const std::vector<const std::vector<Value>*>& faces, int size, std::vector<Value>* out) {
    const auto side = static_cast<size_t>(size);
    out->resize(18 * side * side);
    const Imath::Box2i window({0, 0}, {size - 1, 6 * size - 1});
    const auto indexOf = [side](float column, float row) {
        return 3 * (static_cast<size_t>(std::lround(row)) * side + static_cast<size_t>(std::lround(column)));
    };
    for (int i = 0; i < 6 * size * size; ++i) {
        const auto face = static_cast<Imf::CubeMapFace>(i / (size * size));
        const Imath::V2f inFace(static_cast<float>(i % size), static_cast<float>(i / size % size));
        const Imath::V3f d = Imf::CubeMap::direction(face, window, inFace);
        const Imath::V2f pixel = Imf::CubeMap::pixelPosition(face, window, inFace);
        const FacePlace place = placeIn({d.x, d.y, -d.z});
        const float last = static_cast<float>(size - 1);
        const Value* from = &(*faces[place.face])[indexOf(place.s * last, place.t * last)];
        std::copy_n(from, 3, &(*out)[indexOf(pixel.x, pixel.y)]);
    }
}

/// Where six faces lie among the squares of a picture, in Direct3D's order.
struct CubeLayout {
    int columns, rows;
    Vec2i places[6];
    bool isBackTurned;  ///< upside down
};

constexpr CubeLayout kLayouts[] = {
    {6, 1, {{0, 0}, {1, 0}, {2, 0}, {3, 0}, {4, 0}, {5, 0}}, false},
    {4, 3, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}, false},
    {3, 4, {{2, 1}, {0, 1}, {1, 0}, {1, 2}, {1, 1}, {1, 3}}, true},
};

std::vector<float> squareOf(const ImageF& image, const Vec2i& place, int side) {
    std::vector<float> rgb;
    for (int y = 0; y < side; ++y) {
        const auto row = static_cast<size_t>(place.y * side + y) * static_cast<size_t>(image.width);
        const float* first = &image.rgb[3 * (row + static_cast<size_t>(place.x * side))];
        rgb.insert(rgb.end(), first, first + size_t{3} * static_cast<size_t>(side));
    }
    return rgb;
}

/// But for its rim, which lossy packing may have mixed with its neighbours.
bool isOfOneColor(const std::vector<float>& square, int side) {
    constexpr float kTolerance = 0.01f;
    const auto at = [&](int x, int y) { return &square[3 * static_cast<size_t>(y * side + x)]; };
    const int rim = std::min(16, side / 4);
    const float* first = at(rim, rim);
    for (int y = rim; y < side - rim; ++y) {
        for (int x = rim; x < side - rim; ++x) {
            for (int c = 0; c < 3; ++c) {
                if (std::fabs(at(x, y)[c] - first[c]) > kTolerance) { return false; }
            }
        }
    }
    return true;
}

bool hasEmptySquares(const ImageF& image, const CubeLayout& layout, int side) {
    for (int i = 0; i < layout.columns * layout.rows; ++i) {
        const Vec2i place(i % layout.columns, i / layout.columns);
        const bool isFace = std::ranges::find(layout.places, place) != std::end(layout.places);
        if (!isFace && !isOfOneColor(squareOf(image, place, side), side)) { return false; }
    }
    return true;
}

/// By half a turn: pixels backwards, but not their channels.
void turnOver(std::vector<float>* rgb) {
    std::ranges::reverse(*rgb);
    for (size_t i = 0; i < rgb->size(); i += 3) {
        std::swap((*rgb)[i], (*rgb)[i + 2]);
    }
}

}  // namespace

SceneImage cubeColumn(const std::vector<SceneImage>& faces) {
    const auto made = [&faces](auto member, auto image) {
        std::vector<decltype(&((faces[0].*member)->rgb))> pixels;
        pixels.reserve(faces.size());
        for (const SceneImage& face : faces) {
            pixels.push_back(&(face.*member)->rgb);
        }
        image.width = (faces[0].*member)->width;
        image.height = 6 * image.width;
        turn(pixels, image.width, &image.rgb);
        return std::make_shared<decltype(image)>(std::move(image));
    };
    SceneImage cube;
    if (faces[0].floats) {
        cube.floats = made(&SceneImage::floats, ImageF());
    } else {
        cube.bytes = made(&SceneImage::bytes, Image8());
    }
    return cube;
}

std::vector<SceneImage> facesOf(const ImageF& image) {
    for (const CubeLayout& layout : kLayouts) {
        const int side = image.width / layout.columns;
        if (side < 2 || image.width != side * layout.columns || image.height != side * layout.rows ||
            !hasEmptySquares(image, layout, side)) {
            continue;
        }
        std::vector<SceneImage> faces;
        for (const Vec2i& place : layout.places) {
            ImageF face{side, side, squareOf(image, place, side)};
            if (layout.isBackTurned && faces.size() == 5) { turnOver(&face.rgb); }
            faces.push_back({.floats = std::make_shared<const ImageF>(std::move(face))});
        }
        return faces;
    }
    return {};
}

}  // namespace glint

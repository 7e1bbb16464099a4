#include <algorithm>
#include <cmath>

#include <ImfEnvmap.h>

#include "engine/io/dds_pixels.h"

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

}  // namespace

SceneImage ddsCubeMap(const std::vector<SceneImage>& faces) {
    const auto made = [&faces](auto member, auto picture) {
        std::vector<decltype(&((faces[0].*member)->rgb))> pixels;
        for (const SceneImage& face : faces) {
            pixels.push_back(&(face.*member)->rgb);
        }
        picture.width = (faces[0].*member)->width;
        picture.height = 6 * picture.width;
        turn(pixels, picture.width, &picture.rgb);
        return std::make_shared<decltype(picture)>(std::move(picture));
    };
    SceneImage cube;
    if (faces[0].floats) {
        cube.floats = made(&SceneImage::floats, ImageF());
    } else {
        cube.bytes = made(&SceneImage::bytes, Image8());
    }
    return cube;
}

}  // namespace glint

// Lights with pictures as pbrt-v4 has them. For export_pbrt.cpp.
#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "engine/io/pbrt_writer.h"
#include "engine/io/projected_image.h"
#include "engine/io/scene_export.h"
#include "engine/io/texture_lookup.h"

namespace glint {
namespace {

/// Columns of a picture that interpolates, or whose brightness changes within texels.
constexpr int kFewColumns = 1024;

void append(const Vec3& color, ImageF* image) {
    image->rgb.insert(image->rgb.end(),
                      {std::max(color.x, 0.0f), std::max(color.y, 0.0f), std::max(color.z, 0.0f)});
}

/// Calls colorAt(u, v) in the middle of each pixel, v upwards.
template <class ColorAt>
ImageF painted(int width, int height, const ColorAt& colorAt) {
    ImageF image{width, height, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            append(colorAt(Vec2((static_cast<float>(x) + 0.5f) / static_cast<float>(width),
                                1.0f - (static_cast<float>(y) + 0.5f) / static_cast<float>(height))),
                   &image);
        }
    }
    return image;
}

/// So many of each texel's columns that there are enough.
int columnsFor(int width) { return width * ((kFewColumns + width - 1) / width); }

std::string columns(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& origin) {
    std::string out = "Transform [";
    for (const Vec3& v : {x, y, z}) {
        out += fmt::format("{} {} {} 0 ", v.x, v.y, v.z);
    }
    return out + fmt::format("{} {} {} 1]\n", origin.x, origin.y, origin.z);
}

}  // namespace

ImageF pbrtProjectedImage(const SceneDescription& scene, const Light& light) {
    const int index = light.image.texture;
    const auto lookup =
        index >= 0 ? std::optional(TextureLookup(scene.textures[static_cast<size_t>(index)])) : std::nullopt;
    const bool isImage = lookup && !lookup->isEmpty();
    const int width = columnsFor(isImage ? lookup->width() : 1);
    const int height =
        std::clamp(static_cast<int>(std::lround(static_cast<float>(width) / light.aspect)), 1, 1 << 14);
    const Vec2 half = projectedExtent(light);
    return painted(width, height, [&](const Vec2& uv) {
        const Vec2 place = half * (2.0f * uv - Vec2(1.0f));
        return (isImage ? lookup->at(uv) : light.image.value) * std::pow(1.0f + glm::dot(place, place), 1.5f);
    });
}

ImageF pbrtGoniometricImage(const SceneDescription& scene, const Light& light,
                            std::vector<std::string>* warnings) {
    const TextureLookup lookup(scene.textures[static_cast<size_t>(light.image.texture)]);
    if (lookup.isEmpty()) {
        return painted(1, 1, [&](const Vec2&) { return light.image.value; });
    }
    const Texture& texture = scene.textures[static_cast<size_t>(light.image.texture)];
    const bool isExact = texture.filter == TexelFilter::Nearest && lookup.width() == lookup.height();
    const int size = isExact ? lookup.width() : columnsFor(lookup.width());
    ImageF image = painted(size, size, [&](const Vec2& uv) { return lookup.at(uv); });
    for (size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
        float* rgb = &image.rgb[i];
        const float mean = (rgb[0] + rgb[1] + rgb[2]) / 3.0f;
        if (std::fabs(rgb[0] - mean) + std::fabs(rgb[1] - mean) > 1e-5f * mean) {
            warnOnce("approximated: pictures of goniometric lights are grey", warnings);
        }
        std::fill_n(rgb, 3, mean);
    }
    return image;
}

std::string pbrtImageLight(const Light& light, std::string_view file) {
    const Vec3 direction = glm::normalize(light.direction), right = imageRight(light);
    const Vec3 up = glm::cross(right, direction);
    const std::string image = pbrtString("filename", file) + pbrtNumber("scale", light.strength);
    std::string out = "AttributeBegin\n";
    if (light.kind == LightKind::Goniometric) {
        out += columns(right, direction, -up, light.position) + "LightSource \"goniometric\"" + image +
               pbrtRgb("I", light.color);
    } else {
        const Vec2 half = projectedExtent(light);
        out += columns(right, up, direction, light.position) + "LightSource \"projection\"" + image +
               pbrtNumber("fov", 360.0f / kPi * std::atan(std::min(half.x, half.y)));
    }
    return out + "\nAttributeEnd\n";
}

}  // namespace glint

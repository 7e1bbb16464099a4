#include "engine/builders/texture_table.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "engine/scene/scene_use.h"

namespace glint {
namespace {

template <class Image>
bool hasAllPixels(const Image& image) {
    return image.width > 0 && image.height > 0 &&
           image.rgb.size() == 3 * static_cast<size_t>(image.width) * static_cast<size_t>(image.height);
}

Result<TextureView> makeView(const Texture& texture) {
    const SceneImage& image = texture.image;
    const bool complete =
        image.bytes ? hasAllPixels(*image.bytes) : image.floats && hasAllPixels(*image.floats);
    if (!complete) {
        return Error{fmt::format("texture '{}' {}", texture.name,
                                 image.isRead() ? "has no pixels" : "is used, but has not been read"),
                     {}};
    }
    for (const float number :
         {texture.scale.x, texture.scale.y, texture.offset.x, texture.offset.y, texture.rotationDeg}) {
        if (!std::isfinite(number)) {
            return Error{fmt::format("the scale, offset or rotation of texture '{}' is not a finite number",
                                     texture.name),
                         {}};
        }
    }
    TextureView view;
    view.bytes = image.bytes ? image.bytes->rgb.data() : nullptr;
    view.floats = image.bytes ? nullptr : image.floats->rgb.data();
    view.width = image.bytes ? image.bytes->width : image.floats->width;
    view.height = image.bytes ? image.bytes->height : image.floats->height;
    view.scale = texture.scale;
    if (texture.rotationDeg != 0.0f) {
        const float angleRad = texture.rotationDeg * (kPi / 180.0f);
        view.turn = {std::cos(angleRad), std::sin(angleRad)};
    }
    view.offset = texture.offset;
    view.wrapU = texture.wrapU;
    view.wrapV = texture.wrapV;
    view.filter = texture.filter;
    view.encoding = image.bytes != nullptr ? texture.encoding : ColorEncoding::Linear;
    view.flipV = texture.flipV;
    return view;
}

/// Unless it is listed already.
Status addTexture(const SceneDescription& scene, const Material& user, int index, TextureTable* table) {
    const auto place = static_cast<size_t>(index);
    if (place >= scene.textures.size()) {
        return Error{fmt::format("material '{}' refers to texture {}; the scene has {}", user.name, index,
                                 scene.textures.size()),
                     {}};
    }
    if (table->packedIndex[place] != kNone) { return {}; }
    Result<TextureView> view = makeView(scene.textures[place]);
    if (!view) { return view.error(); }
    table->packedIndex[place] = static_cast<uint32_t>(table->textures.size());
    table->textures.push_back(*view);
    table->images.push_back(scene.textures[place].image);
    return {};
}

bool sameView(const TextureView& a, const TextureView& b) {
    return a.bytes == b.bytes && a.floats == b.floats && a.width == b.width && a.height == b.height &&
           a.scale == b.scale && a.turn == b.turn && a.offset == b.offset && a.encoding == b.encoding &&
           a.flipV == b.flipV && a.wrapU == b.wrapU && a.wrapV == b.wrapV && a.filter == b.filter;
}

bool sameTable(const TextureTable& a, const TextureTable& b) {
    return a.packedIndex == b.packedIndex &&
           std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), b.textures.end(), sameView);
}

}  // namespace

size_t TextureTable::bytes() const { return imageBytes(images); }

size_t imageBytes(const std::vector<SceneImage>& images) {
    std::set<const void*> counted;
    size_t sum = 0;
    for (const SceneImage& image : images) {
        if (image.bytes && counted.insert(image.bytes.get()).second) {
            sum += image.bytes->rgb.size();
        } else if (image.floats && counted.insert(image.floats.get()).second) {
            sum += image.floats->rgb.size() * sizeof(float);
        }
    }
    return sum;
}

Result<std::shared_ptr<const TextureTable>> buildTextureTable(
    const SceneDescription& scene, const std::shared_ptr<const TextureTable>& previous) {
    auto table = std::make_shared<TextureTable>();
    table->packedIndex.assign(scene.textures.size(), kNone);
    const std::vector<bool> used = usedMaterials(scene);
    for (size_t i = 0; i < scene.materials.size(); ++i) {
        if (!used[i]) { continue; }
        for (const int texture : usedTextures(scene.materials[i])) {
            if (const Status status = addTexture(scene, scene.materials[i], texture, table.get()); !status) {
                return status.error();
            }
        }
    }
    if (previous && sameTable(*table, *previous)) { return previous; }
    return std::shared_ptr<const TextureTable>(std::move(table));
}

}  // namespace glint

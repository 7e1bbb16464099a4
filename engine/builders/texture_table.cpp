#include "engine/builders/texture_table.h"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "engine/builders/mip_levels.h"
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
    for (const float number : {texture.scale.x, texture.scale.y, texture.offset.x, texture.offset.y,
                               texture.rotationDeg, texture.base, texture.gain, texture.exponent}) {
        if (!std::isfinite(number)) {
            return Error{
                fmt::format("a number that places or changes texture '{}' is not finite", texture.name), {}};
        }
    }
    TextureView view;
    view.bytes = image.bytes ? image.bytes->rgb.data() : nullptr;
    view.floats = image.bytes ? nullptr : image.floats->rgb.data();
    view.alpha = image.bytes && !image.bytes->alpha.empty() ? image.bytes->alpha.data() : nullptr;
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
    view.channel = texture.channel;
    view.base = texture.base;
    view.gain = texture.gain;
    view.exponent = texture.exponent;
    view.encoding = image.bytes != nullptr ? texture.encoding : ColorEncoding::Linear;
    view.flipV = texture.flipV;
    return view;
}

bool samePixels(const TextureView& a, const TextureView& b) {
    return a.bytes == b.bytes && a.floats == b.floats && a.width == b.width && a.height == b.height &&
           a.encoding == b.encoding;
}

/// The mip map of the last texture of `table`, from one of the tables if it is there.
void addMips(const TextureTable* previous, TextureTable* table) {
    TextureView& view = table->textures.back();
    std::shared_ptr<const std::vector<float>> mips;
    if (view.filter == TexelFilter::Mipmap) {
        for (const TextureTable* known : {static_cast<const TextureTable*>(table), previous}) {
            for (size_t i = 0; known != nullptr && i < known->mips.size() && !mips; ++i) {
                if (samePixels(known->textures[i], view)) { mips = known->mips[i]; }
            }
        }
        if (!mips) { mips = std::make_shared<const std::vector<float>>(mipLevels(view)); }
        view.mips = mips->empty() ? nullptr : mips->data();
    }
    table->mips.push_back(std::move(mips));
}

/// Unless it is listed already.
Status addTexture(const SceneDescription& scene, const std::string& user, int index,
                  const TextureTable* previous, TextureTable* table) {
    const auto place = static_cast<size_t>(index);
    if (place >= scene.textures.size()) {
        return Error{
            fmt::format("'{}' refers to texture {}; the scene has {}", user, index, scene.textures.size()),
            {}};
    }
    if (table->packedIndex[place] != kNone) { return {}; }
    Result<TextureView> view = makeView(scene.textures[place]);
    if (!view) { return view.error(); }
    table->packedIndex[place] = static_cast<uint32_t>(table->textures.size());
    table->textures.push_back(*view);
    table->images.push_back(scene.textures[place].image);
    addMips(previous, table);
    return {};
}

bool sameView(const TextureView& a, const TextureView& b) {
    return samePixels(a, b) && a.alpha == b.alpha && a.scale == b.scale && a.turn == b.turn &&
           a.offset == b.offset && a.flipV == b.flipV && a.wrapU == b.wrapU && a.wrapV == b.wrapV &&
           a.filter == b.filter && a.channel == b.channel && a.base == b.base && a.gain == b.gain &&
           a.exponent == b.exponent;
}

bool sameTable(const TextureTable& a, const TextureTable& b) {
    return a.packedIndex == b.packedIndex &&
           std::equal(a.textures.begin(), a.textures.end(), b.textures.begin(), b.textures.end(), sameView);
}

}  // namespace

size_t TextureTable::bytes() const {
    std::set<const void*> counted;
    size_t sum = imageBytes(images);
    for (const auto& levels : mips) {
        if (levels && counted.insert(levels.get()).second) { sum += levels->size() * sizeof(float); }
    }
    return sum;
}

size_t imageBytes(const std::vector<SceneImage>& images) {
    std::set<const void*> counted;
    size_t sum = 0;
    for (const SceneImage& image : images) {
        if (image.bytes && counted.insert(image.bytes.get()).second) {
            sum += image.bytes->rgb.size() + image.bytes->alpha.size();
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
            if (const Status status =
                    addTexture(scene, scene.materials[i].name, texture, previous.get(), table.get());
                !status) {
                return status.error();
            }
        }
    }
    for (const Light& light : scene.lights) {
        if (!showsImage(light)) { continue; }
        if (Status status = addTexture(scene, light.name, light.image.texture, previous.get(), table.get());
            !status) {
            return status.error();
        }
    }
    if (previous && sameTable(*table, *previous)) { return previous; }
    return std::shared_ptr<const TextureTable>(std::move(table));
}

}  // namespace glint

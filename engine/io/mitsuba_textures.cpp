#include "engine/io/mitsuba_textures.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "engine/io/image_io.h"
#include "engine/io/mitsuba_spectrum.h"
#include "engine/math/color.h"

namespace glint {
namespace {

constexpr std::string_view kNoTexture =
    "approximated: textures of a kind that Glint does not have are a constant 0.5";

template <class Visit>
void forEachPixel(const ImageF& image, const Visit& visit) {
    for (size_t i = 0; i + 2 < image.rgb.size(); i += 3) {
        visit(i, Vec3(image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]));
    }
}

bool isGrey(const Vec3& color) { return color.x == color.y && color.y == color.z; }

}  // namespace

ColorInput MitsubaTextures::color(const MitsubaElement& texture, UvOrigin origin, const Change& change) {
    return {Vec3(0.5f), take(texture, origin, Use::Color, change)};
}

NumberInput MitsubaTextures::number(const MitsubaElement& texture, UvOrigin origin, const Change& change) {
    return {0.5f, take(texture, origin, Use::Number, change)};
}

int MitsubaTextures::take(const MitsubaElement& element, UvOrigin origin, Use use, const Change& change) {
    if (context_.failed()) { return -1; }
    const auto known = taken_.find({&element, origin, use});
    if (known != taken_.end() && !change) { return known->second; }
    MitsubaObject object(&context_, element);
    Texture texture;
    int number = -1;
    if (object.type() == "bitmap" || object.type() == "checkerboard") {
        texture = object.type() == "bitmap" ? makeBitmap(&object, origin, use, change)
                                            : makeCheckerboard(&object, origin, change);
        const std::string_view id = element.attribute("id");
        texture.name = id.empty() ? fmt::format("texture {}", context_.scene.textures.size()) : id;
        number = static_cast<int>(context_.scene.textures.size());
        context_.scene.textures.push_back(std::move(texture));
        object.finish();
    } else if (const MitsubaElement* nested = object.type() == "scale" ? object.next({"texture"}) : nullptr) {
        const float gain = object.number("scale", 1.0f, 0.0f);
        number = take(*nested, origin, use, [&](const Vec3& c) { return gain * (change ? change(c) : c); });
    } else {
        context_.remark(element, kNoTexture, object.type());
    }
    if (!change) { taken_[{&element, origin, use}] = number; }
    return number;
}

/// What stands in the image's middle is placed as Mitsuba's transform has it: uv, with v from the top row,
/// are scaled, turned and moved.
void MitsubaTextures::place(MitsubaObject* object, UvOrigin origin, Texture* texture) {
    const Affine toUv = object->transform("to_uv");
    Vec2 u(toUv.linear[0]), v(toUv.linear[1]), offset(toUv.translation);
    u = u * Vec2(object->number("uscale", 1.0f), object->number("vscale", 1.0f));
    v = v * Vec2(object->number("uscale", 1.0f), object->number("vscale", 1.0f));
    offset += Vec2(object->number("uoffset", 0.0f), object->number("voffset", 0.0f));
    if (origin == UvOrigin::Bottom) {
        if (u == Vec2(1, 0) && v == Vec2(0, 1) && offset == Vec2(0.0f)) { return; }
        offset += v;
        v = -v;
    }
    texture->flipV = true;
    texture->offset = offset;
    const float length = glm::length(u);
    const Vec2 along = length > 0.0f ? u / length : Vec2(1, 0);
    const float shear = glm::dot(along, v), across = along.x * v.y - along.y * v.x;
    texture->scale = {length, across};
    texture->rotationDeg = std::atan2(along.y, along.x) * (180.0f / kPi);
    if (std::fabs(shear) > 1e-4f * (std::fabs(across) + length) || across == 0.0f || length == 0.0f) {
        context_.remark(object->element(), "approximated: textures are placed without shear");
        texture->scale = {length > 0.0f ? length : 1.0f, across != 0.0f ? across : 1.0f};
    }
}

Texture MitsubaTextures::makeBitmap(MitsubaObject* object, UvOrigin origin, Use use, const Change& change) {
    Texture texture;
    place(object, origin, &texture);
    const auto wrapOf = [&](std::string_view name) {
        const std::string_view word = object->text(name, "repeat");
        if (word != "repeat" && word != "mirror" && word != "clamp") {
            context_.remark(object->element(), "approximated: images are clamped beyond their edges", word);
        }
        return word == "repeat" ? WrapMode::Repeat : word == "mirror" ? WrapMode::Mirror : WrapMode::Clamp;
    };
    texture.wrapU = texture.wrapV = wrapOf("wrap_mode");
    if (object->property("wrap_mode_u") != nullptr) { texture.wrapU = wrapOf("wrap_mode_u"); }
    if (object->property("wrap_mode_v") != nullptr) { texture.wrapV = wrapOf("wrap_mode_v"); }
    const bool isNearest = object->text("filter_type") == "nearest";
    texture.filter = isNearest ? TexelFilter::Nearest : TexelFilter::Bilinear;
    const float gamma = object->number("gamma", -1.0f);
    const bool isRaw = object->flag("raw", gamma == 1.0f);
    texture.encoding = isRaw ? ColorEncoding::Linear : ColorEncoding::Srgb;
    object->passOver({"format", "accel", "max_anisotropy", "cache"});
    const MitsubaElement* file = object->property("filename");
    if (file == nullptr) {
        context_.fail(object->element(), "the bitmap has no \"filename\"");
        return texture;
    }
    const std::string path = context_.fileOf(*file, file->attribute("value"));
    texture.image.source = FileSource{path};
    if (use == Use::Color && !change) { return texture; }
    if (const auto pixels = pixelsOf(object, texture.image.source, isRaw)) {
        ImageF changed = *pixels;
        forEachPixel(*pixels, [&](size_t i, const Vec3& c) {
            const Vec3 here = change ? change(c) : c;
            const Vec3 shown = use == Use::Color ? here : Vec3(isGrey(here) ? here.x : luminance(here));
            std::copy_n(&shown.x, 3, changed.rgb.begin() + static_cast<ptrdiff_t>(i));
        });
        texture.image.source = bakedImage(changed, path, context_.scene.textures.size());
    }
    return texture;
}

std::shared_ptr<const ImageF> MitsubaTextures::pixelsOf(MitsubaObject* object, const ImageSource& source,
                                                        bool isRaw) {
    const Result<SceneImage> image = assets_.texture(source);
    if (!image) {
        context_.remark(object->element(), "images cannot be read; 0.5 takes their place",
                        image.error().message);
        return nullptr;
    }
    if (!isRaw || image->floats) { return linearColors(*image); }
    auto raw = std::make_shared<ImageF>(ImageF{image->bytes->width, image->bytes->height, {}});
    for (const uint8_t byte : image->bytes->rgb) {
        raw->rgb.push_back(static_cast<float>(byte) / 255.0f);
    }
    return raw;
}

Texture MitsubaTextures::makeCheckerboard(MitsubaObject* object, UvOrigin origin, const Change& change) {
    Texture texture;
    place(object, origin, &texture);
    texture.filter = TexelFilter::Nearest;
    const auto square = [&](std::string_view name, float otherwise) {
        const auto input = mitsubaInput(object, {name}, SpectrumRole::Emission);
        const Vec3 color = !input ? Vec3(otherwise) : input->texture ? meanOf(*input->texture) : input->color;
        return change ? change(color) : color;
    };
    texture.image.source = Checkerboard{square("color0", 0.4f), square("color1", 0.2f)};
    return texture;
}

std::shared_ptr<const ImageF> MitsubaTextures::pixelsOf(const MitsubaElement& element) {
    MitsubaObject object(&context_, element);
    const int number = take(element, UvOrigin::Top, Use::Color, nullptr);
    if (number < 0) { return nullptr; }
    const Texture& texture = context_.scene.textures[static_cast<size_t>(number)];
    return pixelsOf(&object, texture.image.source, texture.encoding == ColorEncoding::Linear);
}

Vec3 MitsubaTextures::mostOf(const MitsubaElement& element) {
    const auto pixels = pixelsOf(element);
    Vec3 most(pixels ? 0.0f : 0.5f);
    if (pixels) {
        forEachPixel(*pixels, [&](size_t, const Vec3& c) { most = glm::max(most, c); });
    }
    return most;
}

Vec3 MitsubaTextures::meanOf(const MitsubaElement& element) {
    const auto pixels = pixelsOf(element);
    if (!pixels) { return Vec3(0.5f); }
    glm::dvec3 sum(0.0);
    forEachPixel(*pixels, [&](size_t, const Vec3& c) { sum += glm::dvec3(c); });
    return Vec3(sum / (static_cast<double>(pixels->rgb.size()) / 3.0));
}

std::string_view MitsubaTextures::attributeOf(const MitsubaElement& texture) {
    MitsubaObject object(&context_, texture);
    if (object.type() == "vertexcolors") { return "vertex_color"; }
    return object.type() == "mesh_attribute" ? object.text("name", "vertex_color") : std::string_view();
}

}  // namespace glint

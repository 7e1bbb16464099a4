#include "engine/io/pbrt_textures.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "engine/math/color.h"

namespace glint {
namespace {

bool isGrey(const Vec3& color) { return color.x == color.y && color.y == color.z; }

}  // namespace

void PbrtTextures::define(const std::string& name, const std::string& type, const std::string& kind,
                          PbrtParams params) {
    if (type != "float" && type != "spectrum" && type != "color") {
        params.fail(fmt::format("\"{}\" is no type of textures; expected \"float\" or \"spectrum\"", type));
        return;
    }
    definitions_.insert_or_assign(Key{type == "float", name}, Definition{kind, std::move(params)});
}

PbrtValue PbrtTextures::named(const PbrtParams& at, const std::string& name, bool isNumber) {
    const auto found = definitions_.find({isNumber, name});
    if (context_.failed()) { return {}; }
    if (found == definitions_.end()) {
        context_.refuse(at.place(), fmt::format("there is no texture \"{}\" of the type \"{}\"", name,
                                                isNumber ? "float" : "spectrum"));
        return {};
    }
    Definition& definition = found->second;
    if (definition.value) { return *definition.value; }
    constexpr int kMaxNesting = 64;
    if (definition.isOpen || ++nesting_ > kMaxNesting) {
        definition.params.fail("textures refer to each other in a circle, or more than 64 deep");
        return {};
    }
    definition.isOpen = true;
    definition.value = make(definition, isNumber);
    definition.isOpen = false;
    --nesting_;
    if (definition.value->image) { definition.value->image->name = name; }
    definition.params.finish();
    return *definition.value;
}

PbrtValue PbrtTextures::make(const Definition& definition, bool isNumber) {
    const PbrtParams& params = definition.params;
    if (definition.kind == "imagemap") { return makeImage(params, isNumber); }
    if (definition.kind == "constant") { return part(params, "value", isNumber, 1.0f); }
    if (definition.kind == "scale") { return makeScale(params, isNumber); }
    if (definition.kind == "mix" || definition.kind == "directionmix") {
        if (definition.kind == "directionmix") {
            params.approximated("approximated: mixtures by direction are even ones");
            params.passOver({"dir"});
        }
        return makeMix(params, isNumber);
    }
    if (definition.kind == "checkerboard") { return makeCheckerboard(params, isNumber); }
    if (definition.kind == "bilerp") { return makeFourCorners(params, isNumber); }
    if (definition.kind == "dots") { return makeDots(params, isNumber); }
    constexpr std::string_view kNoises[] = {"fbm", "wrinkled", "windy", "marble"};
    if (std::ranges::find(kNoises, definition.kind) != std::end(kNoises)) {
        return makeNoise(params, definition.kind);
    }
    context_.remark(params.place(),
                    "approximated: textures of a kind that Glint does not have are a constant 0.5",
                    definition.kind);
    params.passOver({"scale", "filename", "encoding"});
    return {};
}

PbrtValue PbrtTextures::part(const PbrtParams& params, std::string_view name, bool isNumber,
                             float otherwise) {
    const auto value = isNumber ? number(params, name) : color(params, name, SpectrumRole::Reflectance);
    return value.value_or(PbrtValue{Vec3(otherwise)});
}

std::optional<PbrtValue> PbrtTextures::color(const PbrtParams& params, std::string_view name,
                                             SpectrumRole role) {
    const PbrtParam* param = context_.failed() ? nullptr : params.find(name);
    if (param == nullptr) { return std::nullopt; }
    if (param->type == PbrtType::Texture && !param->texts.empty()) {
        return named(params, param->texts[0], false);
    }
    return PbrtValue{pbrtColor(params, *param, role)};
}

std::optional<PbrtValue> PbrtTextures::number(const PbrtParams& params, std::string_view name) {
    const PbrtParam* param = context_.failed() ? nullptr : params.find(name);
    if (param == nullptr) { return std::nullopt; }
    if (param->type == PbrtType::Texture && !param->texts.empty()) {
        return named(params, param->texts[0], true);
    }
    return PbrtValue{Vec3(params.number(name, 0.5f))};
}

PbrtValue PbrtTextures::adjusted(PbrtValue value, float base, float gain, float exponent) {
    if (!value.image) {
        value.value = glm::pow(glm::max(Vec3(base) + gain * value.value, Vec3(0.0f)), Vec3(exponent));
        return value;
    }
    Texture& image = *value.image;
    if (image.exponent == 1.0f) {
        image.base = base + gain * image.base;
        image.gain *= gain;
        image.exponent = exponent;
    } else if (base == 0.0f && gain >= 0.0f) {
        const float root = std::pow(gain, 1.0f / image.exponent);
        image.base *= root;
        image.gain *= root;
        image.exponent *= exponent;
    }
    return value;
}

PbrtValue PbrtTextures::makeScale(const PbrtParams& params, bool isNumber) {
    const bool isOld = params.has("tex1");
    return scaled(params, part(params, isOld ? "tex1" : "tex", isNumber, 1.0f),
                  part(params, isOld ? "tex2" : "scale", isOld ? isNumber : true, 1.0f));
}

PbrtValue PbrtTextures::makeMix(const PbrtParams& params, bool isNumber) {
    return mixed(params, part(params, "tex1", isNumber, 0.0f), part(params, "tex2", isNumber, 1.0f),
                 part(params, "amount", true, 0.5f));
}

void PbrtTextures::place(const PbrtParams& params, Texture* texture) {
    const std::string mapping = params.text("mapping", "uv");
    if (mapping != "uv") {
        context_.remark(params.place(), "approximated: textures are placed by their meshes' u and v",
                        mapping);
        params.passOver({"v1", "v2"});
    }
    texture->scale = {params.number("uscale", 1.0f), params.number("vscale", 1.0f)};
    texture->offset = {params.number("udelta", 0.0f), params.number("vdelta", 0.0f)};
    if (texture->scale.x == 0.0f || texture->scale.y == 0.0f) {
        context_.remark(params.place(), "approximated: textures of no size are placed as they are");
        texture->scale = Vec2(1.0f);
    }
}

PbrtValue PbrtTextures::makeCheckerboard(const PbrtParams& params, bool isNumber) {
    Texture texture;
    place(params, &texture);
    if (params.integer("dimension", 2, 2, 3) == 3) {
        params.approximated("approximated: checkerboards in space lie on the surface's u and v");
    }
    params.passOver({"aamode"});
    const PbrtValue even = part(params, "tex1", isNumber, 1.0f), odd = part(params, "tex2", isNumber, 0.0f);
    if (even.image || odd.image) {
        params.approximated("approximated: images on squares of a checkerboard are their mean");
    }
    // Glint's has two squares along a unit.
    texture.scale *= 0.5f;
    texture.offset *= 0.5f;
    texture.filter = TexelFilter::Nearest;
    texture.image.source = Checkerboard{meanOf(even), meanOf(odd)};
    return {Vec3(0.5f), texture};
}

ColorInput PbrtTextures::colorInput(const PbrtValue& value) {
    return value.image ? ColorInput{Vec3(0.5f), add(*value.image)} : ColorInput{value.value};
}

NumberInput PbrtTextures::numberInput(const PbrtValue& value) {
    return value.image ? NumberInput{0.5f, add(*value.image)}
                       : NumberInput{isGrey(value.value) ? value.value.x : luminance(value.value)};
}

int PbrtTextures::add(const Texture& t) {
    std::string source = pathOf(t.image.source);
    if (const auto* embedded = std::get_if<EmbeddedFile>(&t.image.source)) { source = embedded->name; }
    if (const auto* board = std::get_if<Checkerboard>(&t.image.source)) {
        const Vec3 &a = board->even, &b = board->odd;
        source = fmt::format("{} {} {} {} {} {}", a.x, a.y, a.z, b.x, b.y, b.z);
    }
    const std::string key =
        fmt::format("{}|{}|{} {} {} {}|{}|{} {} {} {}|{} {} {}", source, static_cast<int>(t.encoding),
                    t.scale.x, t.scale.y, t.offset.x, t.offset.y, t.rotationDeg, static_cast<int>(t.wrapU),
                    static_cast<int>(t.wrapV), static_cast<int>(t.filter), static_cast<int>(t.channel),
                    t.base, t.gain, t.exponent);
    const auto [known, isNew] = added_.try_emplace(key, static_cast<int>(context_.scene.textures.size()));
    if (isNew) {
        context_.scene.textures.push_back(t);
        Texture& added = context_.scene.textures.back();
        if (added.name.empty()) { added.name = fmt::format("texture {}", known->second); }
    }
    return known->second;
}

}  // namespace glint

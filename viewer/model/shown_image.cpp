#include "viewer/model/shown_image.h"

#include <cmath>

#include <fmt/format.h>

#include "engine/render/integrator.h"
#include "viewer/base/units.h"

namespace glint {
namespace {

Vec3 screenColor(const Vec3& linear) { return toneMapped(linear, 0.0f, ToneMap::Srgb); }

std::string colorText(const Vec3& rgb) {
    return fmt::format("R {:.4g}  G {:.4g}  B {:.4g}", rgb.x, rgb.y, rgb.z);
}

std::string normalText(const Vec3& n) { return fmt::format("x {:.3f}  y {:.3f}  z {:.3f}", n.x, n.y, n.z); }

template <int bits>
void askAovs(RenderRequest* request) {
    request->aovs |= bits;
}

void askStandardError(RenderRequest* request) { request->standardError = true; }
void askErrorMaps(RenderRequest* request) { request->errorMaps = true; }
void askIntegratorMaps(RenderRequest* request) { request->integratorMaps = true; }

std::string plainText(float value) { return fmt::format("{:.2g}", value); }
std::string signedText(float value) { return fmt::format("{:+.2g}", value); }
std::string lengthText(float value) { return length(static_cast<double>(value)); }

std::string countText(float value) {
    return value >= 99.5f ? grouped(static_cast<uint64_t>(std::lround(value))) : plainText(value);
}

std::string knownOr(float value, std::string text) {
    return std::isfinite(value) ? std::move(text) : std::string("not known yet");
}

/// In the order of ShownImage.
const std::vector<ShownImageInfo> kFixedImages = {
    {.image = ShownImage::Radiance, .name = "Radiance"},
    {.image = ShownImage::Albedo,
     .name = "Albedo",
     .ask = askAovs<kAovAlbedo>,
     .hitColor = [](const AovSample& hit, const DepthRange&) { return screenColor(hit.albedo); },
     .hitText = [](const AovSample& hit) { return colorText(hit.albedo); }},
    {.image = ShownImage::ShadingNormal,
     .name = "Shading normal",
     .ask = askAovs<kAovShadingNormal>,
     .hitColor = [](const AovSample& hit, const DepthRange&) { return normalColor(hit.shadingNormal); },
     .hitText = [](const AovSample& hit) { return normalText(hit.shadingNormal); }},
    {.image = ShownImage::GeometricNormal,
     .name = "Geometric normal",
     .ask = askAovs<kAovGeometricNormal>,
     .hitColor = [](const AovSample& hit, const DepthRange&) { return normalColor(hit.geometricNormal); },
     .hitText = [](const AovSample& hit) { return normalText(hit.geometricNormal); }},
    {.image = ShownImage::Depth,
     .name = "Depth",
     .ask = askAovs<kAovDepth>,
     .hitColor = [](const AovSample& hit,
                    const DepthRange& range) { return depthColor(hit.depth, range.nearest, range.farthest); },
     .hitText =
         [](const AovSample& hit) {
             return hit.depth > 0.0f ? fmt::format("{:.4g} m", hit.depth) : "nothing hit";
         },
     .isOfRange = true},
    {.image = ShownImage::ObjectId,
     .name = "Object id",
     .ask = askAovs<kAovObjectId>,
     .hitColor = [](const AovSample& hit, const DepthRange&) { return idColor(hit.objectId); },
     .hitText =
         [](const AovSample& hit) {
             return hit.objectId > 0 ? fmt::format("object {}", hit.objectId) : "nothing hit";
         }},
    {.image = ShownImage::MaterialId,
     .name = "Material id",
     .ask = askAovs<kAovMaterialId>,
     .hitColor = [](const AovSample& hit, const DepthRange&) { return idColor(hit.materialId); },
     .hitText =
         [](const AovSample& hit) {
             return hit.materialId > 0 ? fmt::format("material {}", hit.materialId) : "nothing hit";
         }},
    {.image = ShownImage::BoxesTested,
     .name = "Boxes tested",
     .ask = askAovs<kAovBoxesTested>,
     .colors = MapColors::HeatOfAll,
     .unit = "boxes",
     .scaleText = countText,
     .readout = [](float x) { return fmt::format("{} boxes tested", countText(x)); },
     .hitNumber = [](const AovSample& hit) { return hit.boxesTested; }},
    {.image = ShownImage::PrimitivesTested,
     .name = "Triangles tested",
     .ask = askAovs<kAovPrimitivesTested>,
     .colors = MapColors::HeatOfAll,
     .unit = "triangles",
     .scaleText = countText,
     .readout = [](float x) { return fmt::format("{} triangles or other shapes tested", countText(x)); },
     .hitNumber = [](const AovSample& hit) { return hit.primitivesTested; }},
    {.image = ShownImage::NewtonSteps,
     .name = "Newton steps",
     .ask = askAovs<kAovNewtonSteps>,
     .colors = MapColors::HeatOfAll,
     .unit = "steps",
     .scaleText = countText,
     .readout = [](float x) { return fmt::format("{} steps of Newton's method", countText(x)); },
     .hitNumber = [](const AovSample& hit) { return hit.newtonSteps; }},
    {.image = ShownImage::StandardError,
     .name = "Standard error",
     .ask = askStandardError,
     .isOfSecondPass = true,
     .values = [](const FilmSnapshot& s) -> const std::vector<float>& { return s.standardError; },
     .unit = "noise",
     .scaleText = plainText,
     .readout = [](float x) { return knownOr(x, fmt::format("± {:.3g} luminance", x)); }},
    {.image = ShownImage::Bias,
     .name = "Bias",
     .ask = askErrorMaps,
     .has = [](IntegratorKind kind) { return integratorType(kind).hasBias(); },
     .lacking = "bias",
     .values = [](const FilmSnapshot& s) -> const std::vector<float>& { return s.bias; },
     .colors = MapColors::Signed,
     .unit = "bias",
     .scaleText = signedText,
     .readout = [](float x) { return knownOr(x, fmt::format("bias {:+.3g} luminance", x)); }},
    {.image = ShownImage::ErrorBound,
     .name = "Bounded at 90 %",
     .ask = askErrorMaps,
     .isOfSecondPass = true,
     .values = [](const FilmSnapshot& s) -> const std::vector<float>& { return s.errorBound; },
     .unit = "bound at 90 %",
     .scaleText = plainText,
     .readout = [](float x) { return knownOr(x, fmt::format("within ± {:.3g} luminance at 90 %", x)); }},
    {.image = ShownImage::ReferenceError,
     .name = "Error against reference",
     .isAgainstReference = true,
     .unit = "off the reference",
     .scaleText = plainText,
     .readout = [](float x) { return fmt::format("off by {:.3g} radiance", x); }},
};

std::string mapReadout(const IntegratorMapInfo& map, float value) {
    if (map.absent != nullptr && !(value > 0.0f)) { return map.absent; }
    switch (map.quantity) {
        case MapQuantity::Length:
            return fmt::format("{} {}", map.noun, lengthText(value));
        case MapQuantity::Count:
            return fmt::format("{:.1f} {}", value, map.noun);
        case MapQuantity::Presence:
            return map.noun;
    }
    return "";
}

ShownImageInfo imageOfMap(IntegratorKind kind, const IntegratorMapInfo& map) {
    ShownImageInfo info{.name = map.label, .ask = askIntegratorMaps};
    info.has = [kind](IntegratorKind integrator) { return integrator == kind; };
    info.lacking = map.about;
    info.values = [name = map.values](const FilmSnapshot& s) -> const std::vector<float>& {
        return s.map(name);
    };
    info.readout = [&map](float value) { return mapReadout(map, value); };
    info.colors = MapColors::PresentOrNot;
    if (map.quantity != MapQuantity::Presence) {
        info.colors = MapColors::HeatOfAll;
        info.unit = map.noun;
        info.scaleText = map.quantity == MapQuantity::Length ? lengthText : countText;
    }
    return info;
}

std::vector<ShownImageInfo> allImages() {
    std::vector<ShownImageInfo> images = kFixedImages;
    for (const IntegratorInfo& integrator : kIntegratorTable) {
        for (const IntegratorMapInfo& map : integratorType(integrator.kind).maps()) {
            images.push_back(imageOfMap(integrator.kind, map));
            images.back().image = static_cast<ShownImage>(images.size() - 1);
        }
    }
    return images;
}

bool isComparable(const LoadedReference* reference, const FilmSnapshot& snapshot) {
    return reference != nullptr && reference->image.width == snapshot.width &&
           reference->image.height == snapshot.height;
}

}  // namespace

size_t indexOf(const FilmSnapshot& snapshot, Vec2i filmPixel) {
    const Vec2i last(snapshot.width - 1, snapshot.height - 1);
    const Vec2i at = glm::clamp(filmPixel / snapshot.previewScale, Vec2i(0), last);
    return static_cast<size_t>(at.y) * static_cast<size_t>(snapshot.width) + static_cast<size_t>(at.x);
}

Vec3 colorAt(const FilmSnapshot& snapshot, Vec2i filmPixel) {
    const float* rgb = snapshot.radiance.data() + 3 * indexOf(snapshot, filmPixel);
    return {rgb[0], rgb[1], rgb[2]};
}

std::span<const ShownImageInfo> shownImages() {
    static const std::vector<ShownImageInfo> kImages = allImages();
    return kImages;
}

const ShownImageInfo& infoOf(ShownImage image) { return shownImages()[static_cast<size_t>(image)]; }

std::optional<ShownImage> imageNamed(std::string_view name) {
    for (const ShownImageInfo& info : shownImages()) {
        if (name == info.name) { return info.image; }
    }
    return std::nullopt;
}

ShownImage availableImage(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference) {
    const ShownImageInfo& info = infoOf(wanted);
    const bool isThere =
        info.isOf(snapshot.integrator) && (!info.isAgainstReference || isComparable(reference, snapshot));
    return isThere ? wanted : ShownImage::Radiance;
}

std::string noteInstead(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference) {
    const ShownImageInfo& info = infoOf(wanted);
    if (info.isAgainstReference && reference == nullptr) { return "No reference that fits: the radiance"; }
    if (info.isOfSecondPass && snapshot.passes < 2 && snapshot.previewScale == 1) {
        return "Known from the second pass on";
    }
    if (info.isRadiance() && snapshot.isDenoised) { return "Denoised"; }
    if (info.isOf(snapshot.integrator)) { return ""; }
    return fmt::format("{} has no {}: its radiance", integratorInfo(snapshot.integrator).displayName,
                       info.lacking);
}

bool carries(const FilmSnapshot& snapshot, ShownImage wanted) {
    const ShownImageInfo& info = infoOf(wanted);
    if (!info.isOf(snapshot.integrator)) { return true; }
    if (info.values) { return !info.values(snapshot).empty(); }
    return !info.isOfHit() || (snapshot.aovs && snapshot.aovs->passes() > 0);
}

std::string pixelReadout(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference,
                         Vec2i filmPixel) {
    if (snapshot.width <= 0 || snapshot.height <= 0) { return ""; }
    const size_t index = indexOf(snapshot, filmPixel);
    const ShownImageInfo& info = infoOf(availableImage(snapshot, wanted, reference));
    if (info.isRadiance()) {
        const float* rgb = snapshot.radiance.data() + 3 * index;
        return colorText({rgb[0], rgb[1], rgb[2]});
    }
    if (info.isAgainstReference) { return info.readout(errorAgainst(*reference, snapshot, index)); }
    if (info.values) {
        const std::vector<float>& values = info.values(snapshot);
        return index < values.size() ? info.readout(values[index]) : "";
    }
    if (!snapshot.aovs || snapshot.aovs->passes() == 0) { return ""; }
    const AovSample& hit = snapshot.aovs->pixels()[index];
    return info.hitNumber != nullptr ? info.readout(info.hitNumber(hit)) : info.hitText(hit);
}

}  // namespace glint

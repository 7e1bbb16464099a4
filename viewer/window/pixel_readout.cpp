#include "viewer/window/pixel_readout.h"

#include <cmath>

#include <fmt/format.h>

#include "engine/render/sppm_state.h"
#include "viewer/panels/units.h"
#include "viewer/window/shown_image_source.h"

namespace glint {
namespace {

size_t indexOf(const FilmSnapshot& snapshot, Vec2i filmPixel) {
    const Vec2i last(snapshot.width - 1, snapshot.height - 1);
    const Vec2i at = glm::clamp(filmPixel / snapshot.previewScale, Vec2i(0), last);
    return static_cast<size_t>(at.y) * static_cast<size_t>(snapshot.width) + static_cast<size_t>(at.x);
}

std::string colorText(const Vec3& rgb) {
    return fmt::format("R {:.4g}  G {:.4g}  B {:.4g}", rgb.x, rgb.y, rgb.z);
}

std::string normalText(const Vec3& n) { return fmt::format("x {:.3f}  y {:.3f}  z {:.3f}", n.x, n.y, n.z); }

std::string aovText(const AovSample& sample, ShownImage shown) {
    switch (shown) {
        case ShownImage::Albedo:
            return colorText(sample.albedo);
        case ShownImage::ShadingNormal:
            return normalText(sample.shadingNormal);
        case ShownImage::GeometricNormal:
            return normalText(sample.geometricNormal);
        case ShownImage::Depth:
            return sample.depth > 0.0f ? fmt::format("{:.4g} m", sample.depth) : "nothing hit";
        case ShownImage::ObjectId:
            return sample.objectId > 0 ? fmt::format("object {}", sample.objectId) : "nothing hit";
        case ShownImage::MaterialId:
            return sample.materialId > 0 ? fmt::format("material {}", sample.materialId) : "nothing hit";
        case ShownImage::Radiance:
        case ShownImage::StandardError:
        case ShownImage::Bias:
        case ShownImage::ErrorBound:
        case ShownImage::ReferenceError:
        case ShownImage::Radius:
        case ShownImage::PhotonCount:
        case ShownImage::VisiblePoints:
            break;
    }
    return "";
}

std::string photonText(const FilmSnapshot& snapshot, size_t index, ShownImage shown) {
    const bool counts = shown == ShownImage::PhotonCount;
    const std::vector<float>& values = snapshot.map(counts ? kPhotonCountMap : kRadiusMap);
    if (index >= values.size()) { return ""; }
    const float value = values[index];
    if (counts) { return fmt::format("{:.1f} photons", value); }
    if (!(value > 0.0f)) { return "no visible point"; }
    return shown == ShownImage::Radius ? "radius " + length(static_cast<double>(value)) : "visible point";
}

std::string mapText(const std::vector<float>& values, size_t index, const char* format) {
    if (index >= values.size()) { return ""; }
    return std::isfinite(values[index]) ? fmt::format(fmt::runtime(format), values[index]) : "not known yet";
}

}  // namespace

std::string pixelReadout(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference,
                         Vec2i filmPixel) {
    if (snapshot.width <= 0 || snapshot.height <= 0) { return ""; }
    const size_t index = indexOf(snapshot, filmPixel);
    const ShownImage shown = imageOf(snapshot, wanted, reference);
    if (shown == ShownImage::Radiance) {
        const float* rgb = snapshot.radiance.data() + 3 * index;
        return colorText({rgb[0], rgb[1], rgb[2]});
    }
    if (shown == ShownImage::StandardError) {
        return mapText(snapshot.standardError, index, "± {:.3g} luminance");
    }
    if (shown == ShownImage::Bias) { return mapText(snapshot.bias, index, "bias {:+.3g} luminance"); }
    if (shown == ShownImage::ErrorBound) {
        return mapText(snapshot.errorBound, index, "within ± {:.3g} luminance at 90 %");
    }
    if (shown == ShownImage::ReferenceError) {
        return fmt::format("off by {:.3g} radiance", errorAgainst(*reference, snapshot, index));
    }
    if (isOfPhotons(shown)) { return photonText(snapshot, index, shown); }
    if (!snapshot.aovs || snapshot.aovs->passes() == 0) { return ""; }
    return aovText(snapshot.aovs->pixels()[index], shown);
}

}  // namespace glint

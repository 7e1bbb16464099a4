#include "viewer/window/picture_source.h"

#include <cmath>

namespace glint {
namespace {

Vec3 screenColor(const Vec3& linear) { return toneMapped(linear, 0.0f, ToneMap::Srgb); }

Vec3 falseColor(const AovSample& sample, ShownPicture shown, const DepthRange& range) {
    switch (shown) {
        case ShownPicture::Albedo:
            return screenColor(sample.albedo);
        case ShownPicture::ShadingNormal:
            return normalColor(sample.shadingNormal);
        case ShownPicture::GeometricNormal:
            return normalColor(sample.geometricNormal);
        case ShownPicture::Depth:
            return depthColor(sample.depth, range.nearest, range.farthest);
        case ShownPicture::ObjectId:
            return idColor(sample.objectId);
        case ShownPicture::MaterialId:
            return idColor(sample.materialId);
        case ShownPicture::Radiance:
        case ShownPicture::StandardError:
            break;
    }
    return Vec3(0.0f);
}

DepthRange rangeOf(const std::vector<AovSample>& samples) {
    std::vector<float> depths;
    depths.reserve(samples.size());
    for (const AovSample& sample : samples) depths.push_back(sample.depth);
    return depthRange(depths);
}

std::vector<float> grey(const std::vector<float>& values) {
    std::vector<float> rgb;
    rgb.reserve(values.size() * 3);
    for (const float value : values) rgb.insert(rgb.end(), 3, std::isfinite(value) ? value : 0.0f);
    return rgb;
}

}  // namespace

std::vector<float> falseColors(const FilmSnapshot& snapshot, ShownPicture shown) {
    if (shown == ShownPicture::StandardError) return grey(snapshot.standardError);
    if (!snapshot.aovs || snapshot.aovs->passes() == 0) return {};
    const std::vector<AovSample>& samples = snapshot.aovs->pixels();
    const DepthRange range = shown == ShownPicture::Depth ? rangeOf(samples) : DepthRange{};
    std::vector<float> rgb;
    rgb.reserve(samples.size() * 3);
    for (const AovSample& sample : samples) {
        const Vec3 color = falseColor(sample, shown, range);
        rgb.insert(rgb.end(), {color.x, color.y, color.z});
    }
    return rgb;
}

void PictureSource::show(const ViewerModel& model, ImageDisplay* display) {
    const auto& snapshot = model.snapshot();
    const ShownPicture kind = model.display.shown;
    const bool radiance = kind == ShownPicture::Radiance;
    if (snapshot && snapshot->width > 0 && (snapshot != shown_ || kind != shownKind_)) {
        if (!radiance) falseColors_ = falseColors(*snapshot, kind);
        const std::vector<float>& rgb = radiance ? snapshot->radiance : falseColors_;
        // A picture that has not been made yet leaves the one before on the screen.
        if (rgb.size() == static_cast<size_t>(snapshot->width) * static_cast<size_t>(snapshot->height) * 3) {
            display->upload(rgb.data(), snapshot->width, snapshot->height, snapshot->previewScale > 1);
            shownKind_ = kind;
        }
        shown_ = snapshot;
    }
    const bool displayValues =
        shownKind_ != ShownPicture::Radiance && shownKind_ != ShownPicture::StandardError;
    display->update({model.display.exposureStops, model.display.toneMap, displayValues});
}

}  // namespace glint

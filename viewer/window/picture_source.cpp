#include "viewer/window/picture_source.h"

#include <cmath>

namespace glint {
namespace {

const Vec3 kVisiblePoint(0.72f, 0.80f, 0.72f);
const Vec3 kNoVisiblePoint(0.22f, 0.09f, 0.20f);

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
        case ShownPicture::Radius:
        case ShownPicture::PhotonCount:
        case ShownPicture::VisiblePoints:
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

std::vector<float> heatColors(const std::vector<float>& values, HeatScale* heat) {
    *heat = heatScale(values);
    std::vector<float> rgb;
    rgb.reserve(values.size() * 3);
    for (const float value : values) {
        const Vec3 color = heatColor(value, *heat);
        rgb.insert(rgb.end(), {color.x, color.y, color.z});
    }
    return rgb;
}

std::vector<float> visiblePointColors(const std::vector<float>& radii) {
    std::vector<float> rgb;
    rgb.reserve(radii.size() * 3);
    for (const float radius : radii) {
        const Vec3 color = radius > 0.0f ? kVisiblePoint : kNoVisiblePoint;
        rgb.insert(rgb.end(), {color.x, color.y, color.z});
    }
    return rgb;
}

}  // namespace

ShownPicture pictureOf(const FilmSnapshot& snapshot, ShownPicture wanted) {
    const bool lacksPhotons = snapshot.integrator != IntegratorKind::Sppm;
    return isOfPhotons(wanted) && lacksPhotons ? ShownPicture::Radiance : wanted;
}

std::vector<float> falseColors(const FilmSnapshot& snapshot, ShownPicture shown, HeatScale* heat) {
    if (shown == ShownPicture::StandardError) return grey(snapshot.standardError);
    if (shown == ShownPicture::Radius) return heatColors(snapshot.radiusWorld, heat);
    if (shown == ShownPicture::PhotonCount) return heatColors(snapshot.photonCount, heat);
    if (shown == ShownPicture::VisiblePoints) return visiblePointColors(snapshot.radiusWorld);
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

void PictureSource::show(const std::shared_ptr<const FilmSnapshot>& snapshot, const DisplaySettings& settings,
                         ImageDisplay* display) {
    const bool isNew = snapshot != shown_ || settings.shown != wantedKind_;
    if (snapshot && snapshot->width > 0 && isNew) {
        const ShownPicture kind = pictureOf(*snapshot, settings.shown);
        const bool radiance = kind == ShownPicture::Radiance;
        HeatScale heat;
        if (!radiance) falseColors_ = falseColors(*snapshot, kind, &heat);
        const std::vector<float>& rgb = radiance ? snapshot->radiance : falseColors_;
        // A picture that has not been made yet leaves the one before on the screen.
        if (rgb.size() == static_cast<size_t>(snapshot->width) * static_cast<size_t>(snapshot->height) * 3) {
            display->upload(rgb.data(), snapshot->width, snapshot->height, snapshot->previewScale > 1);
            shownKind_ = kind;
            shownIntegrator_ = snapshot->integrator;
            heat_ = heat;
        }
        shown_ = snapshot;
        wantedKind_ = settings.shown;
    }
    const bool displayValues =
        shownKind_ != ShownPicture::Radiance && shownKind_ != ShownPicture::StandardError;
    display->update({settings.exposureStops, settings.toneMap, displayValues});
}

}  // namespace glint

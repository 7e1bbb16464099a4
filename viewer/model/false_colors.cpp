#include "viewer/model/false_colors.h"

#include <algorithm>
#include <cmath>

namespace glint {
namespace {

const Vec3 kPresent(0.72f, 0.80f, 0.72f);
const Vec3 kAbsent(0.22f, 0.09f, 0.20f);

constexpr size_t kChannels = 4;
constexpr size_t kRampSteps = 1024;

/// Writes pixels one after another.
class ColorWriter {
  public:
    explicit ColorWriter(size_t pixels) : rgba_(pixels * kChannels, 255), next_(rgba_.data()) {}
    void add(const Vec3& display) {
        for (int c = 0; c < 3; ++c) {
            next_[c] = displayByte(display[c]);
        }
        next_ += kChannels;
    }
    std::vector<uint8_t> take() { return std::move(rgba_); }

  private:
    std::vector<uint8_t> rgba_;
    uint8_t* next_;
};

DepthRange rangeOf(const std::vector<AovSample>& samples) {
    std::vector<float> depths;
    depths.reserve(samples.size());
    for (const AovSample& sample : samples) {
        depths.push_back(sample.depth);
    }
    return depthRange(depths);
}

/// From four decades below nearly the largest value up to it: a few fireflies must not set the scale.
HeatScale scaleWithoutOutliers(const std::vector<float>& values) {
    constexpr size_t kSamples = 16384;
    constexpr double kShare = 0.999;
    constexpr float kDecades = 1e-4f;
    std::vector<float> sizes;
    const size_t step = std::max<size_t>(1, values.size() / kSamples);
    for (size_t i = 0; i < values.size(); i += step) {
        const float size = std::fabs(values[i]);
        if (size > 0.0f && std::isfinite(size)) { sizes.push_back(size); }
    }
    if (sizes.empty()) { return {}; }
    const auto high = sizes.begin() + static_cast<ptrdiff_t>(kShare * static_cast<double>(sizes.size() - 1));
    std::nth_element(sizes.begin(), high, sizes.end());
    const float largest = *high;
    const float smallest = *std::min_element(sizes.begin(), sizes.end());
    return {std::max(smallest, largest * kDecades), largest};
}

/// The heat ramp as a table: a picture asks for millions of its colours.
std::vector<Vec3> heatRamp() {
    std::vector<Vec3> ramp(kRampSteps);
    for (size_t i = 0; i < kRampSteps; ++i) {
        ramp[i] = heatColor(static_cast<float>(i) / static_cast<float>(kRampSteps - 1));
    }
    return ramp;
}

std::vector<uint8_t> heatColors(const std::vector<float>& values, const HeatScale& heat) {
    static const std::vector<Vec3> kRamp = heatRamp();
    const float lowest = std::log2(heat.smallest);
    const float span = std::log2(heat.largest) - lowest;
    ColorWriter colors(values.size());
    for (const float value : values) {
        const bool isThere = value > 0.0f && std::isfinite(value);
        if (!isThere) {
            colors.add(Vec3(0.0f));
            continue;
        }
        const float share = span > 1e-6f ? (std::log2(value) - lowest) / span : 0.5f;
        const float step = std::clamp(share, 0.0f, 1.0f) * static_cast<float>(kRampSteps - 1);
        colors.add(kRamp[static_cast<size_t>(std::lround(step))]);
    }
    return colors.take();
}

std::vector<uint8_t> signedColors(const std::vector<float>& values, float largest) {
    ColorWriter colors(values.size());
    for (const float value : values) {
        colors.add(std::isfinite(value) && largest > 0.0f ? signedColor(value / largest) : Vec3(0.0f));
    }
    return colors.take();
}

std::vector<float> errorsAgainst(const LoadedReference& reference, const FilmSnapshot& snapshot) {
    std::vector<float> errors(snapshot.radiance.size() / 3);
    for (size_t i = 0; i < errors.size(); ++i) {
        errors[i] = errorAgainst(reference, snapshot, i);
    }
    return errors;
}

std::vector<uint8_t> presenceColors(const std::vector<float>& values) {
    ColorWriter colors(values.size());
    for (const float value : values) {
        colors.add(value > 0.0f ? kPresent : kAbsent);
    }
    return colors.take();
}

}  // namespace

std::vector<uint8_t> mapColors(const std::vector<float>& values, MapColors how, MapScale* scale) {
    if (how == MapColors::PresentOrNot) {
        *scale = {};
        return presenceColors(values);
    }
    scale->isSigned = how == MapColors::Signed;
    if (!scale->isThere()) {
        scale->heat = how == MapColors::HeatOfAll ? heatScale(values) : scaleWithoutOutliers(values);
    }
    return scale->isSigned ? signedColors(values, scale->heat.largest) : heatColors(values, scale->heat);
}

std::vector<uint8_t> falseColors(const FilmSnapshot& snapshot, ShownImage shown,
                                 const LoadedReference* reference, MapScale* scale) {
    const ShownImageInfo& info = infoOf(shown);
    if (info.values) { return mapColors(info.values(snapshot), info.colors, scale); }
    if (info.isAgainstReference) {
        return mapColors(errorsAgainst(*reference, snapshot), info.colors, scale);
    }
    if (!info.isOfHit() || !snapshot.aovs || snapshot.aovs->passes() == 0) {
        *scale = {};
        return {};
    }
    const std::vector<AovSample>& samples = snapshot.aovs->pixels();
    if (info.hitNumber != nullptr) {
        std::vector<float> numbers(samples.size());
        std::ranges::transform(samples, numbers.begin(), info.hitNumber);
        return mapColors(numbers, info.colors, scale);
    }
    *scale = {};
    const DepthRange range = info.isOfRange ? rangeOf(samples) : DepthRange{};
    ColorWriter colors(samples.size());
    for (const AovSample& sample : samples) {
        colors.add(info.hitColor(sample, range));
    }
    return colors.take();
}

std::vector<uint8_t> toneMappedColors(const FilmSnapshot& snapshot, const DisplayLook& look) {
    const Image8 image = toneMapImage(snapshot.radiance.data(), snapshot.width, snapshot.height, look, 1);
    std::vector<uint8_t> rgba(image.rgb.size() / 3 * 4, 255);
    for (size_t i = 0; 3 * i < image.rgb.size(); ++i) {
        std::copy_n(&image.rgb[3 * i], 3, &rgba[4 * i]);
    }
    return rgba;
}

}  // namespace glint

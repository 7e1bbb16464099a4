// KHR_materials_iridescence, by what its film reflects at normal incidence.
#include <algorithm>
#include <cmath>
#include <complex>

#include "engine/io/gltf_surface.h"
#include "engine/io/spectrum_colors.h"

namespace glint {
namespace {

/// Between air and what lies below, whose amplitudes interfere (Airy 1833; Born and Wolf, "Principles of
/// Optics", section 7.6).
struct Film {
    double ior = 1.3;
    double thicknessNm = 400.0;

    double reflectance(double iorBelow, double nm) const {
        const double above = (1.0 - ior) / (1.0 + ior), below = (ior - iorBelow) / (ior + iorBelow);
        const std::complex<double> turned =
            below * std::polar(1.0, 4.0 * static_cast<double>(kPi) * ior * thicknessNm / nm);
        return std::norm((above + turned) / (1.0 + above * turned));
    }

    Vec3 color(double iorBelow) const {
        std::vector<SpectrumSample> samples;
        for (double nm = 360.0; nm <= 780.0; nm += 5.0) {
            samples.push_back({nm, reflectance(iorBelow, nm)});
        }
        return glm::clamp(rgbOfSpectrum(samples, SpectrumRole::Reflectance), Vec3(0.0f), Vec3(1.0f));
    }
};

/// Of the surface that reflects that share at normal incidence.
float iorOf(float reflectance) {
    constexpr float kMost = 0.98f;
    const float root = std::sqrt(clampf(reflectance, 0.0f, kMost));
    return (1.0f + root) / (1.0f - root);
}

}  // namespace

void takeIridescence(const tinygltf::Value& extension, Material* out) {
    const float share = gltfNumber(numberOf(&extension, "iridescenceFactor", 0.0), 0.0, 1.0);
    const double thickness = numberOf(&extension, "iridescenceThicknessMaximum", 400.0);
    if (share == 0.0f || out->kind != MaterialKind::Principled) { return; }
    const Film film{std::clamp(numberOf(&extension, "iridescenceIor", 1.3), 1.0, 10.0),
                    std::clamp(std::isfinite(thickness) ? thickness : 400.0, 0.0, 1e5)};
    if (out->color.texture < 0 && out->metallic != NumberInput{0.0f}) {
        Vec3 metal(0.0f);
        for (int c = 0; c < 3; ++c) {
            metal[c] = film.color(static_cast<double>(iorOf(out->color.value[c])))[c];
        }
        out->color.value = glm::mix(out->color.value, metal, share * out->metallic.value);
    }
    const float own = square((out->ior.value - 1.0f) / (out->ior.value + 1.0f));
    const Vec3 base = own * out->specular.value * out->specularTint.value;
    const Vec3 seen = glm::mix(base, film.color(static_cast<double>(out->ior.value)), share);
    const float most = maxComponent(seen);
    if (out->metallic.value == 1.0f || out->specular.texture >= 0 || out->specularTint.texture >= 0 ||
        most <= 0.0f) {
        return;
    }
    out->ior.value = iorOf(most);
    out->specular.value = 1.0f;
    out->specularTint.value = seen / most;
}

}  // namespace glint

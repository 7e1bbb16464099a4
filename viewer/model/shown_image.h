// The images that can be shown of a render: one line each in shown_image.cpp says where its numbers come
// from, who has them, what the session is asked for, and how they become colours and text. The integrators'
// own maps follow from their tables.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/render/render_session.h"
#include "engine/render/tonemap.h"
#include "viewer/model/reference_errors.h"

namespace glint {

/// Beyond the last of these come the integrators' own maps, which imageNamed() finds.
enum class ShownImage : uint8_t {
    Radiance,
    Albedo,
    ShadingNormal,
    GeometricNormal,
    Depth,
    ObjectId,
    MaterialId,
    BoxesTested,       ///< by the camera's ray: boxes and planes of acceleration structures
    PrimitivesTested,  ///< likewise: triangles and other shapes
    NewtonSteps,       ///< likewise: evaluations of turned profiles
    StandardError,     ///< noise: of the mean luminance
    Bias,              ///< estimate of the luminance's bias, signed
    ErrorBound,        ///< with 90 %, the true luminance is within so much
    ReferenceError,    ///< against the loaded reference
};

/// How numbers become colours.
enum class MapColors : uint8_t {
    Heat,          ///< from nearly the largest down over four decades at most: a few fireflies do not count
    HeatOfAll,     ///< from the smallest to the largest
    Signed,        ///< both ways from black
    PresentOrNot,  ///< above 0 or not
};

struct ShownImageInfo {
    ShownImage image = ShownImage::Radiance;
    const char* name;  ///< for people and scripts
    /// Adds to a request what snapshots have to carry. Null: every snapshot carries it.
    void (*ask)(RenderRequest* request) = nullptr;

    /// Which integrators have it, and what all others lack. Nothing: all have it.
    std::function<bool(IntegratorKind)> has{};
    const char* lacking = nullptr;
    bool isOfSecondPass = false;  ///< one pass alone says nothing

    // Of images with a value for each pixel.
    /// Empty while the snapshot does not carry them. Null: no such image, or one against the reference.
    std::function<const std::vector<float>&(const FilmSnapshot& snapshot)> values{};
    bool isAgainstReference = false;
    MapColors colors = MapColors::Heat;
    const char* unit = "";                          ///< behind the scale's upper end
    std::function<std::string(float)> scaleText{};  ///< at the scale's ends
    std::function<std::string(float)> readout{};    ///< of one pixel

    /// Of images of a number of the camera's first hit, which have the four above, too.
    float (*hitNumber)(const AovSample& hit) = nullptr;

    // Of other images of the camera's first hit. Display values.
    Vec3 (*hitColor)(const AovSample& hit, const DepthRange& range) = nullptr;
    std::string (*hitText)(const AovSample& hit) = nullptr;
    bool isOfRange = false;  ///< hitColor() looks at the range of all depths; else that is {}

    bool isOfHit() const { return hitColor != nullptr || hitNumber != nullptr; }
    bool isRadiance() const { return values == nullptr && !isOfHit() && !isAgainstReference; }
    bool isOf(IntegratorKind integrator) const { return !has || has(integrator); }
};

/// In the order of ShownImage, which is that of the panel.
std::span<const ShownImageInfo> shownImages();
const ShownImageInfo& infoOf(ShownImage image);
/// By ShownImageInfo::name; nothing for any other text.
std::optional<ShownImage> imageNamed(std::string_view name);

/// What the snapshot can show: `wanted`, or its radiance where its integrator has no such image, or where the
/// reference is missing or of another size.
ShownImage availableImage(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference);

/// What a snapshot shows instead of `wanted`, and why, for the image's corner; that it is denoised; "" when
/// it shows what is wanted as it was rendered.
std::string noteInstead(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference);

/// The snapshot holds what `wanted` is made of, or never will.
bool carries(const FilmSnapshot& snapshot, ShownImage wanted);

/// Of a pixel that counts in full resolution and is clamped to the picture, which must have one: its place in
/// the snapshot's lists, and its linear radiance.
size_t indexOf(const FilmSnapshot& snapshot, Vec2i filmPixel);
Vec3 colorAt(const FilmSnapshot& snapshot, Vec2i filmPixel);

/// The value under the mouse, in the terms of the image that is shown: the status line's text. `filmPixel`
/// counts in full resolution and is clamped to the image. "" where the snapshot does not carry that image
/// (yet). `reference` may be null.
std::string pixelReadout(const FilmSnapshot& snapshot, ShownImage wanted, const LoadedReference* reference,
                         Vec2i filmPixel);

}  // namespace glint

// Colours and constants of Mitsuba's files.
#pragma once

#include <optional>

#include "engine/io/mitsuba_object.h"
#include "engine/io/spectrum_colors.h"

namespace glint {

/// A colour: rgb, srgb, spectrum, blackbody or a single number. Not negative; reflectances up to 1.
Vec3 mitsubaColor(MitsubaContext* context, const MitsubaElement& at, SpectrumRole role);

/// A colour, or the texture that stands in its place.
struct MitsubaInput {
    Vec3 color{0.5f};
    const MitsubaElement* texture = nullptr;
};

/// The first of these properties that is there, which may be a texture; nothing: none is.
std::optional<MitsubaInput> mitsubaInput(MitsubaObject* object, std::initializer_list<std::string_view> names,
                                         SpectrumRole role);

/// The index of refraction of a named dielectric, as Mitsuba has them; nothing for an unknown name.
std::optional<float> mitsubaIndex(std::string_view name);

/// eta and k of a named conductor.
struct MitsubaMetal {
    Vec3 eta, k;
};
/// Mitsuba's short names, "Au"; nothing for one that Glint has no constants of.
std::optional<MitsubaMetal> mitsubaMetal(std::string_view name);

}  // namespace glint

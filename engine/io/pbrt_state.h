// What directives set and later ones use. Internal to the pbrt importer.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include <glm/mat4x4.hpp>

#include "engine/io/pbrt_params.h"

namespace glint {

/// What the defaults of an Attribute directive are for.
enum class PbrtTarget : uint8_t { Shape, Light, Material, Medium, Texture };

struct PbrtState {
    glm::dmat4 transform{1.0};
    /// The numbers of a LookAt that is all of the transform but for a mirrored x; empty: there is more.
    std::vector<double> look = {};
    bool movesStart = true;  ///< false: directives move what stands at the end of the exposure only
    bool isReversed = false;
    int material = -1;          ///< a number of PbrtMaterials; -1: pbrt's default
    int areaLight = -1;         ///< a number of PbrtAreaLights; -1: none
    std::string interior = {};  ///< the medium within shapes; empty: none
    PbrtColorSpace space = PbrtColorSpace::Srgb;
    std::array<std::shared_ptr<const PbrtParams>, 5> defaults{};
};

/// Fails, and gives the identity, where the map is not affine or has numbers above 1e18.
Affine affineOf(PbrtContext* context, const PbrtPlace& at, const glm::dmat4& matrix);
/// What a transform directive multiplies the current one by; nothing for other directives.
glm::dmat4 transformOf(PbrtContext* context, const PbrtPlace& at, std::string_view directive,
                       const std::vector<double>& numbers);

}  // namespace glint

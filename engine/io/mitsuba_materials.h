// Mitsuba's bsdfs as Glint's materials. Internal to the Mitsuba importer. engine/io/README.md says what
// becomes what.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "engine/io/mitsuba_object.h"
#include "engine/io/mitsuba_spectrum.h"
#include "engine/io/mitsuba_textures.h"

namespace glint {

/// The refractive index outside where a scene says nothing.
constexpr float kAir = 1.000277f;

/// A bsdf as it is on a shape, before the shape shines.
struct MitsubaSurface {
    Material material;
    bool isThere = true;                   ///< false: it lets all pass
    bool isTwoSided = false;               ///< or lets light through; otherwise its back is black
    const MitsubaElement* back = nullptr;  ///< two-sided: of a bsdf of its own
    /// The mesh's colours are this attribute of it, from `low` where it is 0 to `high` where it is 1.
    std::string attribute = {};
    Vec3 low{0.0f}, high{1.0f};
};

class MitsubaMaterials {
  public:
    MitsubaMaterials(MitsubaContext* context, MitsubaTextures* textures)
        : context_(*context), textures_(*textures) {}

    /// Null: Mitsuba's default, a diffuse grey.
    const MitsubaSurface& surfaceOf(const MitsubaElement* bsdf, UvOrigin origin);
    /// The number in the scene of a surface that does not shine.
    int take(const MitsubaElement* bsdf, UvOrigin origin);
    /// Appends one that does.
    int add(const MitsubaSurface& surface, const ColorInput& emission, bool bothSides);
    /// One that is there where the surface is, and reflects nothing.
    int black(const MitsubaSurface& surface);
    ColorInput emissionOf(const MitsubaElement& texture, UvOrigin origin) {
        return textures_.color(texture, origin);
    }

  private:
    using Key = std::pair<const MitsubaElement*, UvOrigin>;
    using Read = void (MitsubaMaterials::*)(MitsubaObject*, UvOrigin, MitsubaSurface*);
    struct Kind;

    MitsubaSurface read(const MitsubaElement& bsdf, UvOrigin origin);
    MitsubaSurface nested(MitsubaObject* object, UvOrigin origin);

    void readDiffuse(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readTransmitter(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readDielectric(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readConductor(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readPlastic(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readPhong(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readWard(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    /// The two reflectances that Phong's and Ward's models have.
    void readReflectances(MitsubaObject* object, UvOrigin origin, Material* material);
    void readCoating(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readMask(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readTwoSided(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readBump(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readNormalMap(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readBlend(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readNull(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readPrincipled(MitsubaObject* object, UvOrigin origin, MitsubaSurface* out);
    void readPrincipledLayers(MitsubaObject* object, UvOrigin origin, const Vec3& base, Material* material);

    void readPrincipledRoughness(MitsubaObject* object, UvOrigin origin, Material* material);
    void readRoughness(MitsubaObject* object, UvOrigin origin, Material* material);
    /// The factors of what a smooth boundary reflects and lets through, as one tint.
    void readTints(MitsubaObject* object, UvOrigin origin, std::string_view reflected,
                   std::string_view passed, Material* material);
    float readIndex(MitsubaObject* object, std::string_view name, float otherwise);
    ColorInput colorOf(const MitsubaInput& input, UvOrigin origin,
                       const MitsubaTextures::Change& change = nullptr);
    /// A number in [0, 1], each of whose values `change` makes another one.
    NumberInput numberOf(MitsubaObject* object, std::string_view name, UvOrigin origin, float otherwise,
                         const std::function<float(float)>& change = nullptr);
    float meanNumber(MitsubaObject* object, std::string_view name, float otherwise);

    MitsubaContext& context_;
    MitsubaTextures& textures_;
    std::map<Key, MitsubaSurface> surfaces_;
    std::map<Key, int> numbers_;
    std::map<std::pair<float, int>, int> blacks_;  ///< by opacity
};

}  // namespace glint

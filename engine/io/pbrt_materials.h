// pbrt's materials as Glint's. Internal to the pbrt importer. engine/io/README.md says what becomes what.
#pragma once

#include <array>
#include <deque>
#include <map>
#include <string>
#include <tuple>

#include "engine/io/pbrt_textures.h"

namespace glint {

/// A material as it is on a shape, before the shape shines or is cut out.
struct PbrtSurface {
    Material material;
    bool isThere = true;             ///< false: an interface, which lets all pass
    PbrtValue share = {Vec3(1.0f)};  ///< of the surface that is there
};

/// Light that leaves a shape.
struct PbrtEmission {
    ColorInput color{Vec3(0.0f)};
    float strength = 1.0f;
    bool isTwoSided = false;
};

class PbrtMaterials {
  public:
    PbrtMaterials(PbrtContext* context, PbrtTextures* textures) : context_(*context), textures_(*textures) {}

    /// A Material directive; its number.
    int define(const std::string& kind, PbrtParams params);
    /// MakeNamedMaterial.
    void defineNamed(const std::string& name, PbrtParams params);
    /// NamedMaterial; the number that the name has or will have.
    int numberOf(const std::string& name, const PbrtPlace& at);

    /// -1: pbrt's default, a diffuse grey.
    const PbrtSurface& surfaceOf(int number);
    /// The number in the scene of a surface of which `share` is there, with light or without, around what
    /// absorbs so much per unit of length.
    int take(int number, const PbrtValue& share, const PbrtEmission& emission,
             const Vec3& absorption = Vec3(0.0f));

    /// MakeNamedMedium.
    void defineMedium(const std::string& name, const PbrtParams& params);
    /// What a medium absorbs within glass; 0, with a remark, elsewhere. Fails where there is none of
    /// that name.
    Vec3 absorptionIn(int number, const std::string& medium, const PbrtParams& at);

  private:
    struct Definition {
        std::string kind;  ///< empty: only its name is known
        std::string name;
        PbrtParams params;
        std::optional<PbrtSurface> surface = {};  ///< once it has been asked for
        bool isOpen = false;                      ///< while it is
    };
    using Read = void (PbrtMaterials::*)(const PbrtParams&, PbrtSurface*);
    struct Kind;

    PbrtSurface read(const Definition& definition);
    void readDiffuse(const PbrtParams& params, PbrtSurface* out);
    void readCoatedDiffuse(const PbrtParams& params, PbrtSurface* out);
    void readConductor(const PbrtParams& params, PbrtSurface* out);
    void readCoatedConductor(const PbrtParams& params, PbrtSurface* out);
    void readDielectric(const PbrtParams& params, PbrtSurface* out);
    void readThinDielectric(const PbrtParams& params, PbrtSurface* out);
    void readTransmission(const PbrtParams& params, PbrtSurface* out);
    void readMix(const PbrtParams& params, PbrtSurface* out);
    void readInterface(const PbrtParams& params, PbrtSurface* out);
    void readMeasured(const PbrtParams& params, PbrtSurface* out);
    void readHair(const PbrtParams& params, PbrtSurface* out);
    void readSubsurface(const PbrtParams& params, PbrtSurface* out);
    void readMirror(const PbrtParams& params, PbrtSurface* out);
    void readOldCoated(const PbrtParams& params, PbrtSurface* out);
    void readDisney(const PbrtParams& params, PbrtSurface* out);

    void readRelief(const PbrtParams& params, Material* material);
    /// Sets the roughness, and that across where the parameters for u and v differ.
    void readRoughness(const PbrtParams& params, const std::string& prefix, float otherwise,
                       Material* material);
    ColorInput reflectance(const PbrtParams& params, std::initializer_list<std::string_view> names,
                           float otherwise);
    /// eta and k of a metal, over the index of what lies on it.
    void readMetal(const PbrtParams& params, const std::string& prefix, float index, Material* material);
    /// The same of a coated one by what it would reflect without its coat.
    void readCoatedReflectance(const PbrtParams& params, const PbrtValue& bare, float index,
                               Material* material);
    /// The index of a coat.
    float coatIndex(const PbrtParams& params, std::string_view name);
    float meanNumber(const PbrtParams& params, std::string_view name, float otherwise);

    PbrtContext& context_;
    PbrtTextures& textures_;
    std::deque<Definition> definitions_;
    std::map<std::string, int> named_;
    std::optional<PbrtSurface> usual_;
    std::map<std::string, Vec3> media_;  ///< what they absorb
    using Key = std::tuple<int, float, int, std::array<float, 6>, int, float, bool>;
    std::map<Key, int> taken_;
    int nesting_ = 0;
};

}  // namespace glint

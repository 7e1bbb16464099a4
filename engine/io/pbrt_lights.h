// pbrt's lights, with a shape and without. Internal to the pbrt importer.
#pragma once

#include <vector>

#include "engine/io/pbrt_materials.h"
#include "engine/io/pbrt_state.h"

namespace glint {

class PbrtLights {
  public:
    PbrtLights(PbrtContext* context, PbrtTextures* textures, AssetCache* assets)
        : context_(*context), textures_(*textures), assets_(*assets) {}

    /// LightSource: appended to the scene's lights, or its environment.
    void place(const std::string& kind, const PbrtParams& params, const PbrtState& state);
    /// AreaLightSource; its number.
    int defineArea(const std::string& kind, PbrtParams params);
    /// What leaves a shape that has the area light. `area` is all of it, in the units of pbrt's "power";
    /// `parts`: its triangles, which pbrt counts each as a light.
    PbrtEmission emissionOf(int number, double area, size_t parts);
    /// Whether emissionOf() looks at the area.
    bool needsArea(int number) const { return areas_[static_cast<size_t>(number)].has("power"); }
    bool showsImage(int number) const { return areas_[static_cast<size_t>(number)].has("filename"); }

  private:
    Light* add(const PbrtParams& params, LightKind kind, const std::string& name, float powerOfOne);
    void placePoint(const PbrtParams& params, const Affine& toWorld);
    void placeSpot(const PbrtParams& params, const Affine& toWorld);
    void placeDistant(const PbrtParams& params, const Affine& toWorld);
    void placeGoniometric(const PbrtParams& params, const Affine& toWorld);
    void placeProjection(const PbrtParams& params, const Affine& toWorld);
    void placeInfinite(const PbrtParams& params, const Affine& toWorld);
    void placePortal(const PbrtParams& params);
    void placeMap(const PbrtParams& params, const Affine& toWorld, bool isLatLong);
    Vec3 colorOf(const PbrtParams& params, std::string_view name);

    PbrtContext& context_;
    PbrtTextures& textures_;
    AssetCache& assets_;
    std::vector<PbrtParams> areas_;
};

}  // namespace glint

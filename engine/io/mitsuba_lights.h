// Mitsuba's emitters without a shape. Internal to the Mitsuba importer.
#pragma once

#include "engine/io/mitsuba_object.h"
#include "engine/io/mitsuba_textures.h"

namespace glint {

class MitsubaLights {
  public:
    MitsubaLights(MitsubaContext* context, MitsubaTextures* textures, AssetCache* assets)
        : context_(*context), textures_(*textures), assets_(*assets) {}

    /// Appends the emitter to the scene's lights, or makes it its environment.
    void place(const MitsubaElement& emitter);

  private:
    void placePoint(MitsubaObject* object);
    void placeSpot(MitsubaObject* object);
    void placeDirectional(MitsubaObject* object);
    void placeProjector(MitsubaObject* object);
    void placeConstant(MitsubaObject* object);
    void placeMap(MitsubaObject* object);
    void placeSky(MitsubaObject* object);
    Light* add(MitsubaObject* object, LightKind kind, std::initializer_list<std::string_view> radiometry);
    float aspectOf(const ColorInput& image);
    bool takesEnvironment(MitsubaObject* object);
    SceneImage imageOf(MitsubaObject* object, const std::string& path, const Affine& toWorld);

    MitsubaContext& context_;
    MitsubaTextures& textures_;
    AssetCache& assets_;
};

}  // namespace glint

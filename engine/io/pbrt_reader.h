// Obeys the directives of a pbrt scene: what they set, and what they place. Internal to the pbrt importer.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/io/asset_cache.h"
#include "engine/io/pbrt_camera.h"
#include "engine/io/pbrt_parser.h"
#include "engine/io/pbrt_shapes.h"

namespace glint {

class PbrtReader {
  public:
    PbrtReader(const std::string& path, const LoadOptions& options);

    Result<SceneDescription> read();

  private:
    /// What a directive that begins something keeps for its end.
    struct Saved {
        std::string_view begin, end;
        PbrtPlace place;
        PbrtState state;
    };
    using Obey = void (PbrtReader::*)(PbrtDirective*);
    struct Kind {
        std::string_view name;
        Obey obey;
    };

    void obey(PbrtDirective* directive);
    Result<SceneDescription> finish();
    Status readAssets();

    void begin(PbrtDirective* directive);
    void end(PbrtDirective* directive);
    void transform(PbrtDirective* directive);
    void remember(PbrtDirective* directive);
    void recall(PbrtDirective* directive);
    void activate(PbrtDirective* directive);
    void setDefaults(PbrtDirective* directive);
    void setColorSpace(PbrtDirective* directive);
    void beginWorld(PbrtDirective* directive);
    void passOver(PbrtDirective*) {}
    void setMedium(PbrtDirective* directive);
    void setView(PbrtDirective* directive);
    void setMaterial(PbrtDirective* directive);
    void setTexture(PbrtDirective* directive);
    void setAreaLight(PbrtDirective* directive);
    void placeLight(PbrtDirective* directive);
    void placeShape(PbrtDirective* directive);
    void placeObject(PbrtDirective* directive);

    /// The directive's parameters with those that Attribute sets.
    PbrtParams& paramsOf(PbrtDirective* directive, PbrtTarget target);
    bool isWithin(std::string_view begin) const;
    void place(std::vector<Object> objects, const Affine& toWorld, const PbrtPlace& at);

    PbrtContext context_;
    PbrtParser parser_;
    AssetCache assets_;
    PbrtTextures textures_;
    PbrtMaterials materials_;
    PbrtLights lights_;
    PbrtShapes shapes_;
    PbrtView view_;
    PbrtState state_;
    std::vector<Saved> stack_;
    std::map<std::string, glm::dmat4> coordinates_;
    std::map<std::string, std::vector<Object>> objects_;
    std::string objectName_;
    bool isWorld_ = false;
};

}  // namespace glint

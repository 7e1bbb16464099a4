// Small pictures on the graphics card, for panels that list them.
#pragma once

#include <map>
#include <vector>

#include "viewer/model/example_scenes.h"
#include "viewer/model/preset_pictures.h"
#include "viewer/model/snapshots.h"
#include "viewer/window/gl_api.h"

namespace glint {

class ThumbnailTextures {
  public:
    /// `gl` has to stay current until release().
    void create(const GlApi& gl) { gl_ = gl; }
    void release();
    /// Makes those that are missing, and gives up those of pictures that are no longer kept.
    void update(std::vector<KeptPicture>* kept);
    /// The same for the examples, which stay.
    void update(std::vector<ExampleScene>* examples);
    /// The same of the library's materials.
    void update(std::vector<PresetSheet>* sheets);

  private:
    unsigned int make(const Thumbnail& thumbnail) const;
    template <class Listed>
    void makeMissing(std::vector<Listed>* listed);

    GlApi gl_;
    std::map<int, unsigned int> textures_;  ///< by the pictures' numbers
    std::vector<unsigned int> lasting_;
};

}  // namespace glint

// The names of everything in the scene, and which of them are looked for.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "viewer/model/scene_document.h"

namespace glint {

struct OutlinerEntry {
    enum class Kind : uint8_t { Object, Light, Material, Texture, Hidden };
    Kind kind;
    int index;
    std::string label;  ///< unlike that of any other
};

class Outliner {
  public:
    std::string search;
    /// Those whose labels hold the search, in any case (ASCII). Made anew only when the scene or the search
    /// is another one.
    const std::vector<OutlinerEntry>& entries(const SceneDocument& document);
    /// Of all, found or not.
    size_t count() const { return count_; }

  private:
    std::shared_ptr<const SceneDescription> scene_;
    std::string searched_;
    std::vector<OutlinerEntry> entries_;
    size_t count_ = 0;
};

}  // namespace glint

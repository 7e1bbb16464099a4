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
    Kind kind = Kind::Object;
    int index = 0;
    std::string label;  ///< unlike that of any other
};

class Outliner {
  public:
    std::string search;
    /// Once a frame, before all else: of the scene as it is posted. Looks through the names only where there
    /// is a search, and it or the scene is another one.
    void update(const SceneDocument& document);
    /// Those whose labels hold the search, in any case (ASCII).
    size_t size() const { return searched_.empty() ? count() : found_.size(); }
    /// The entry of a row below size(); its label is made here.
    OutlinerEntry at(size_t row) const;
    /// Of all, found or not.
    size_t count() const;
    /// How many labels were made so far.
    uint64_t labelsMade() const { return labelsMade_; }

  private:
    OutlinerEntry entryOf(size_t index) const;

    std::shared_ptr<const SceneDescription> scene_;
    std::string searched_;
    std::vector<uint32_t> found_;  ///< among all
    mutable uint64_t labelsMade_ = 0;
};

}  // namespace glint

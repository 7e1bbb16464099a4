// A scene as the history keeps it: lists share what they have in common with those of the scene before, so
// that a thousand steps of a scene of thousands of objects cost little more than the scene.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// A list in pieces, which other lists may share.
template <class Item>
class KeptList {
  public:
    /// Of more items; fewer where the list was cut.
    static constexpr size_t kMostInPiece = 64;

    /// Takes the pieces of `like` that `items` begins and ends with, and copies the rest. Returns how many
    /// items it copied.
    size_t keep(const std::vector<Item>& items, const KeptList* like);
    std::vector<Item> items() const;

  private:
    using Piece = std::shared_ptr<const std::vector<Item>>;
    std::vector<Piece> pieces_;
};

class KeptScene {
  public:
    /// `like`: the scene before, or null.
    KeptScene(const std::shared_ptr<const SceneDescription>& scene, const KeptScene* like);

    /// The very object as long as anyone else has it, then a copy that equals it in every field.
    std::shared_ptr<const SceneDescription> scene() const;
    /// Of all lists, how many items this one copied instead of sharing them.
    size_t itemsCopied() const { return itemsCopied_; }

  private:
    /// Of all lists of a scene, in the order of its fields.
    using Lists = std::tuple<KeptList<Texture>, KeptList<SceneImage>, KeptList<Material>, KeptList<Mesh>,
                             KeptList<Object>, KeptList<Object>, KeptList<Light>, KeptList<std::string>,
                             KeptList<std::string>, KeptList<std::string>>;

    std::weak_ptr<const SceneDescription> itself_;
    SceneDescription rest_;  ///< all but the lists
    Lists lists_;
    size_t itemsCopied_ = 0;
};

}  // namespace glint

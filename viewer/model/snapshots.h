// Pictures that were kept, with the scene and the look that made them, and which of them are compared.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/scene/scene.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/thumbnail.h"

namespace glint {

struct KeptRender {
    int number = 0;       ///< for people, from 1; no two have the same
    std::string summary;  ///< integrator, passes, time and error
    std::shared_ptr<const FilmSnapshot> image;
    std::shared_ptr<const SceneDescription> scene;
    DisplayLook look{};
    Thumbnail thumbnail;

    std::string name() const { return "Snapshot " + std::to_string(number); }
};

class Snapshots {
  public:
    /// Keeps the picture as it is shown. Previews and empty ones are not kept: false.
    bool keep(const std::shared_ptr<const FilmSnapshot>& image, std::shared_ptr<const SceneDescription> scene,
              const DisplaySettings& display);
    void remove(int number);
    const std::vector<KeptRender>& kept() const { return kept_; }
    /// In how many settings the picture's scene differs from `now`. Found once for each version of the scene.
    size_t differences(const KeptRender& kept, const std::shared_ptr<const SceneDescription>& now) const;
    /// Null: there is none of that number.
    const KeptRender* find(int number) const;

    /// The one that is left in the comparison; 0: none is compared.
    int left = 0;
    /// What it is compared with; 0: the live picture.
    int right = 0;
    bool isComparing() const { return left != 0; }

    /// The picture of this moment is to be kept.
    void askToKeep() { keepsNow_ = true; }
    bool takeKeep() { return std::exchange(keepsNow_, false); }

    /// The scene of that picture is to be opened again.
    void askForScene(int number) { asked_ = number; }
    const KeptRender* takeAsked() { return find(std::exchange(asked_, 0)); }

  private:
    struct Found {
        std::shared_ptr<const SceneDescription> of;
        size_t differences = 0;
    };
    std::vector<KeptRender> kept_;
    mutable std::map<int, Found> found_;  ///< by the pictures' numbers
    int lastNumber_ = 0;
    int asked_ = 0;
    bool keepsNow_ = false;
};

}  // namespace glint

// Small renders of the library's materials: a ball of each under a sky, made by a job when a group is first
// looked at.
#pragma once

#include <cstddef>
#include <vector>

#include "viewer/base/job_queue.h"
#include "viewer/model/backend_maker.h"
#include "viewer/model/material_presets.h"
#include "viewer/model/thumbnail.h"

namespace glint {

/// The balls of a group in rows of kColumns, squares of kSide pixels each.
struct PresetSheet {
    static constexpr int kColumns = 8, kSide = 48;
    Thumbnail thumbnail{};  ///< no pixels: not rendered yet, or it could not be

    /// Where a preset's ball is, in shares of the thumbnail.
    Vec2 cornerOf(size_t preset) const;
    Vec2 cellSize() const;
};

/// The scene that such a sheet shows.
SceneDescription presetScene(const MaterialPresetGroup& group);

class PresetImages {
  public:
    explicit PresetImages(JobQueue* jobs);

    BackendMaker makeBackend;  ///< what renders them; without one there are none

    /// One for each of materialPresets().
    std::vector<PresetSheet> sheets;
    /// Begins to render the group's, unless that was done.
    void ask(size_t group);

  private:
    JobQueue* jobs_;
    std::vector<bool> isAsked_;
};

}  // namespace glint

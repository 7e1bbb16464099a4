// The film as files: images, and checkpoints out and in. Each takes the film exactly, in the background.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/notice.h"
#include "viewer/model/overwrite_guard.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"

namespace glint {

/// The layers that an EXR file can hold.
inline constexpr uint32_t kAllAovs =
    kAovAlbedo | kAovShadingNormal | kAovGeometricNormal | kAovDepth | kAovObjectId | kAovMaterialId;

/// As the display shows it, with exposure, tone map and what else it has. Error: it cannot be written.
Status saveShownImage(const std::string& path, const SessionCapture& capture, const DisplaySettings& display);

class FilmFiles {
  public:
    /// A scene that a checkpoint is of, and how its file was read.
    struct ResumedScene {
        SceneDescription scene;
        SceneReading reading;
    };
    /// Goes on from a checkpoint, as an edit of this name, after opening its scene where there is one.
    using Resume = std::function<void(std::optional<ResumedScene>, ResumePoint, const std::string& name)>;
    FilmFiles(JobQueue* jobs, const SceneDocument* document, RenderControl* render, Notice* notice,
              const RunFiles* inputs, OverwriteGuard* guard, Resume resume)
        : jobs_(jobs),
          document_(document),
          render_(render),
          notice_(notice),
          inputs_(inputs),
          guard_(guard),
          resume_(std::move(resume)) {}

    std::string png = "render.png";
    std::string exr = "render.exr";
    std::string checkpoint = "render.glintfilm";
    bool exrFloat = false;
    bool exrLayers = false;
    bool isAutomatic = false;  ///< checkpoints are saved again and again while it renders
    float automaticSeconds = 300.0f;

    /// As shown, with exposure and tone map.
    void savePng(const DisplaySettings& display);
    /// The same into the file `path`; blocks.
    Status saveNow(const std::string& path, const DisplaySettings& display);
    /// Waits for the layers first, where they are wanted.
    void saveExr(const DisplaySettings& display);
    /// Not over a longer film, which is an error; asks before it replaces one of another scene.
    void saveCheckpointFile();
    /// With the scene that the checkpoint holds where it is not of the one that is open.
    void resume(const std::string& file);

    /// The session has to make layers.
    bool needsLayers() const { return exrLayers || isExrPending_; }
    bool isExrPending() const { return isExrPending_; }
    /// Once a frame: goes on with what waited for layers, and saves by itself. `busy`: other jobs are
    /// under way.
    void refresh(bool busy);

  private:
    using Save = std::function<Status(const SessionCapture&)>;
    /// Takes the film when the pass in flight is done, then runs `save` on it, both in the background. Asks
    /// before it replaces a file that it has not written `of` the same.
    void saveCaptured(const std::string& path, Save save, const std::string& of = {});
    void startSave(const std::string& path, Save save);
    /// Under another name where the file holds a longer film, or one of another scene.
    void autosave();
    void startExr();

    JobQueue* jobs_;
    const SceneDocument* document_;
    RenderControl* render_;
    Notice* notice_;
    const RunFiles* inputs_;
    OverwriteGuard* guard_;
    Resume resume_;
    bool isExrPending_ = false;
    bool exrDenoises_ = false;  ///< of the file that is pending
    double lastAutosave_ = 0.0;
};

}  // namespace glint

// The film as files: images, and checkpoints out and in. Each takes the film exactly, in the background.
#pragma once

#include <functional>
#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/notice.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"

namespace glint {

/// The layers that an EXR file can hold.
inline constexpr uint32_t kAllAovs =
    kAovAlbedo | kAovShadingNormal | kAovGeometricNormal | kAovDepth | kAovObjectId | kAovMaterialId;

class FilmFiles {
  public:
    FilmFiles(JobQueue* jobs, const SceneDocument* document, RenderControl* render, Notice* notice,
              const RunFiles* inputs)
        : jobs_(jobs), document_(document), render_(render), notice_(notice), inputs_(inputs) {}

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
    void saveExr();
    /// Not over a longer film: an automatic save goes to another name then, any other one is an error.
    void saveCheckpointFile();
    void resumeCheckpoint();

    /// The session has to make layers.
    bool needsLayers() const { return exrLayers || isExrPending_; }
    bool isExrPending() const { return isExrPending_; }
    /// Once a frame: goes on with what waited for layers, and saves by itself. `busy`: other jobs are under
    /// way.
    void refresh(bool busy);

  private:
    /// Takes the film when the pass in flight is done, then runs `save` on it, both in the background.
    void saveCaptured(const std::string& path, std::function<Status(const SessionCapture&)> save);
    void startExr();

    JobQueue* jobs_;
    const SceneDocument* document_;
    RenderControl* render_;
    Notice* notice_;
    const RunFiles* inputs_;
    bool isExrPending_ = false;
    double lastAutosave_ = 0.0;
};

}  // namespace glint

// All that the window shows and edits, part by part, and what joins the parts once a frame.
//
// Panels take the parts that they need (workspace_part.h). Whatever takes time (loading, saving, measuring)
// runs as a job. Lives on the UI thread; nothing here draws.
#pragma once

#include <memory>
#include <string>

#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/asset_reader.h"
#include "viewer/model/convergence_watch.h"
#include "viewer/model/curve_export.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/fault_finder.h"
#include "viewer/model/film_files.h"
#include "viewer/model/notice.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"

namespace glint {

class Workspace {
  public:
    explicit Workspace(std::unique_ptr<Backend> backend);
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    RunFiles inputs;  ///< no save replaces them
    JobQueue jobs;    ///< before the render, whose end answers the jobs that wait for a film
    Notice notice;    ///< of the last save, load or resume
    SceneDocument document;
    RenderControl render;
    DisplaySettings display;
    SceneFiles sceneFiles;
    FilmFiles filmFiles;
    AssetReader assets;
    ConvergenceWatch convergence;
    CurveExport curveExport;
    FaultFinder faults;
    /// Set by who draws: what is on the screen is not of the newest snapshots yet.
    bool displayIsBehind = false;

    /// Opens a scene that is in memory.
    void adopt(SceneDescription scene);
    /// A file that was dropped on the window: an image becomes the reference, a checkpoint (.glintfilm) is
    /// resumed, anything else is opened as a scene.
    void takeDroppedFile(const std::string& path);

    // Once a frame: first refresh(), then what draws and edits, then commitEdits().
    void refresh();
    /// `held`: the user is holding a control or the camera, so passes run at low resolution until
    /// finishMotion(). Returns what was posted.
    EditKind commitEdits(bool held);
    void finishMotion() { render.setInteracting(false); }

    bool busy() const;
    /// An edit was posted, or waits for a file, and no image of it has come back.
    bool awaitsEdit() const { return render.awaitsImage() || assets.reading(); }
    /// The snapshots carry what DisplaySettings::shown asks for.
    bool carriesShownImage() const;
    /// Whose image is left of the divider, and whose is right of it.
    ComparedPair comparedPair() const { return display.pairOf(document.draft().options.integrator); }

  private:
    void sendRequest();
    void chooseExposure();

    bool awaitsExposure_ = false;  ///< the scene was opened, and no picture of it has come
};

}  // namespace glint

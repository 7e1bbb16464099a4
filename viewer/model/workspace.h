// All that the window shows and edits, part by part, and what joins the parts once a frame.
//
// Panels take the parts that they need (workspace_part.h). Whatever takes time (loading, saving, measuring)
// runs as a job. Lives on the UI thread; nothing here draws.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "engine/render/first_hits.h"
#include "viewer/base/camera_bookmarks.h"
#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/asset_reader.h"
#include "viewer/model/convergence_watch.h"
#include "viewer/model/curve_export.h"
#include "viewer/model/denoised_view.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/edit_history.h"
#include "viewer/model/example_scenes.h"
#include "viewer/model/fault_finder.h"
#include "viewer/model/file_watch.h"
#include "viewer/model/film_files.h"
#include "viewer/model/frame_series.h"
#include "viewer/model/gizmo.h"
#include "viewer/model/inspector.h"
#include "viewer/model/key_map.h"
#include "viewer/model/lens_settings.h"
#include "viewer/model/material_presets.h"
#include "viewer/model/notice.h"
#include "viewer/model/ocio_chooser.h"
#include "viewer/model/outliner.h"
#include "viewer/model/preset_images.h"
#include "viewer/model/region_tool.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"
#include "viewer/model/scene_files.h"
#include "viewer/model/session_backup.h"
#include "viewer/model/shown_difference.h"
#include "viewer/model/snapshots.h"
#include "viewer/model/window_layout.h"

namespace glint {

class Workspace {
  public:
    explicit Workspace(std::unique_ptr<Backend> backend);
    Workspace(const Workspace&) = delete;
    Workspace& operator=(const Workspace&) = delete;

    RunFiles inputs;  ///< no save replaces them
    JobQueue jobs;    ///< before the render, whose end answers the jobs that wait for a film
    Notice notice;    ///< of the last save, load or resume
    OverwriteGuard overwrite;
    SceneDocument document;
    SessionBackup backup;  ///< before the render, as jobs
    EditHistory history;   ///< of the document
    RenderControl render;
    DisplaySettings display;
    OcioChooser ocio;
    LensSettings lens;
    FocusOverlay focusOverlay;
    Inspector inspector;
    RegionTool region;
    GizmoSettings gizmo;
    Outliner outliner;
    MaterialLibrary library;
    PresetImages presets{&jobs};
    SceneFiles sceneFiles;
    FilmFiles filmFiles;
    AssetReader assets;
    ConvergenceWatch convergence;
    CurveExport curveExport;
    CameraBookmarks bookmarks;
    FrameSeries frames;
    Examples examples;
    FileWatch watch;  ///< of the scene that is open
    FaultFinder faults;
    Snapshots snapshots;
    ShownDifference difference;
    DenoisedView denoised;
    WindowLayout layout;
    KeyMap keys;
    /// Set by who draws: what is on the screen is not of the newest snapshots yet.
    bool displayIsBehind = false;

    /// What outlives the session is kept in that folder, and the session itself every so many seconds.
    void rememberIn(const std::string& folder, double backupSeconds);
    /// Opens a scene that is in memory, as an edit that can be undone.
    /// `isSaved`: it is as its file says.
    void adopt(SceneDescription scene, bool isSaved = true);
    /// A file that was dropped on the window: an image becomes the reference, a checkpoint (.glintfilm) is
    /// resumed, anything else is opened as a scene.
    void takeDroppedFile(const std::string& path);

    /// Focuses on what is seen in this pixel of the picture; tells where nothing is.
    void focusAt(Vec2i pixel);
    /// Selects the object that is seen there, and its material; none where nothing is.
    void selectAt(Vec2i pixel);
    /// Gives the object in the pixel a material, or says that there is none.
    void giveMaterialAt(Vec2i pixel, const MaterialDrag& given);

    // Once a frame: first refresh(), then what draws and edits, then commitEdits().
    void refresh();
    /// The draft's edits, or else a restart, undo or redo that was asked for. `held`: the user is holding a
    /// control or the camera, so passes run at low resolution until finishMotion(), and all edits until it is
    /// let go are one step of the history. `mayBeEdited`: there was input not long ago; without, and with no
    /// job that ended, the draft is taken for what it was: looking through thousands of objects for edits
    /// takes time. Returns whether anything was posted.
    bool commitEdits(bool held, bool mayBeEdited = true);
    void finishMotion() { render.setInteracting(false); }

    bool busy() const;
    /// An edit was posted, or waits for a file, and no image of it has come back.
    bool awaitsEdit() const { return render.awaitsImage() || assets.reading(); }
    /// The snapshots carry what DisplaySettings::shown asks for.
    bool carriesShownImage() const;
    /// Whose image is left of the divider, and whose is right of it.
    ComparedPair comparedPair() const { return display.pairOf(document.draft().options.integrator); }
    /// Two pictures are on the screen, or their difference.
    bool isComparing() const { return display.split || snapshots.isComparing(); }
    /// The picture that the own pane shows, and the one of the other pane, which matters while isComparing().
    const std::shared_ptr<const FilmSnapshot>& ownImage() const;
    const std::shared_ptr<const FilmSnapshot>& otherImage() const;
    /// Of a comparison of snapshots always; else as the table of integrators has it.
    bool ownIsRight() const;

  private:
    bool wantsDenoised() const;
    /// As it is shown.
    const std::shared_ptr<const FilmSnapshot>& liveImage() const;
    void sendRequest();
    void addObjectsOf(SceneDescription scene);
    FirstHit hitAt(Vec2i pixel) const;
    void refreshDifference();
    /// Another program has changed a file of the scene.
    void reload();
    void openSceneOf(const KeptRender& kept);
    void chooseExposure();
    void expectExposure();
    bool commitDraft(bool held, bool mayBeEdited);
    void goTo(size_t state);
    void restart();
    void resumeFrom(std::optional<FilmFiles::ResumedScene> resumed, ResumePoint point,
                    const std::string& name);
    /// What was known of the scene before.
    void forgetScene();

    bool jobsEnded_ = false;       ///< since the last commit: they may have edited the draft
    bool awaitsExposure_ = false;  ///< the scene was opened, and no picture of it has come
    uint64_t gesture_ = 1;         ///< counts what the user does at one go
};

}  // namespace glint

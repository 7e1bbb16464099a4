// What the window shows and edits: the scene's draft, the render session, and everything the panels set.
//
// Panels change the public settings and draft() and know nothing of restarts: commitEdits() finds the
// smallest edit, once a frame. Whatever takes time (loading, saving) runs as a job. Lives on the UI thread;
// nothing here draws.
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/math/bounds.h"
#include "engine/render/render_session.h"
#include "engine/render/tonemap.h"
#include "viewer/window/job_queue.h"
#include "viewer/window/reference_errors.h"
#include "viewer/window/reference_fit.h"

namespace glint {

struct CompletedScene;

/// Which picture is shown. AOVs are asked of the session only while they are shown or saved.
enum class ShownImage {
    Radiance,
    Albedo,
    ShadingNormal,
    GeometricNormal,
    Depth,
    ObjectId,
    MaterialId,
    StandardError,   ///< noise: of the mean luminance
    Bias,            ///< SPPM: estimate of the luminance's bias, signed
    ErrorBound,      ///< with 90 %, the true luminance is within so much
    ReferenceError,  ///< against the loaded reference
    Radius,          ///< SPPM: present radius, metres
    PhotonCount,     ///< SPPM: photons kept so far
    VisiblePoints,   ///< SPPM: which pixels hold one
};
constexpr int kShownImageCount = 14;
/// Pictures that need SPPM's radii and photon counts.
constexpr bool isOfPhotons(ShownImage shown) {
    return shown == ShownImage::Radius || shown == ShownImage::PhotonCount ||
           shown == ShownImage::VisiblePoints;
}
/// Pictures that path tracing does not have.
constexpr bool isOfSppm(ShownImage shown) { return isOfPhotons(shown) || shown == ShownImage::Bias; }

struct DisplaySettings {
    float exposureStops = 0.0f;
    ToneMap toneMap = ToneMap::Srgb;
    ShownImage shown = ShownImage::Radiance;
    bool pixelScale = false;  ///< one screen pixel a picture pixel, instead of fitting the window
    bool split = false;       ///< path tracing left of the divider, SPPM right of it, at equal render time
    float splitAt = 0.5f;     ///< the divider, as a share of the picture's width
};

/// What the Convergence panel shows.
struct ConvergenceSettings {
    ReferenceMetric metric = ReferenceMetric::RelativeRmse;
    double targetError = 0.01;  ///< relative; the stop limit takes its place while there is one
};

struct FileSettings {
    std::string scene;
    std::string reference;
    std::string csv = "convergence.csv";
    std::string png = "render.png";
    std::string exr = "render.exr";
    std::string checkpoint = "render.glintfilm";
    std::string json = "scene.json";
    bool exrFloat = false;
    bool exrLayers = false;
    bool automatic = false;
    float automaticSeconds = 300.0f;
};

class ViewerModel {
  public:
    explicit ViewerModel(std::unique_ptr<Backend> backend);
    ViewerModel(const ViewerModel&) = delete;
    ViewerModel& operator=(const ViewerModel&) = delete;

    // The scene.
    bool hasScene() const { return posted_ != nullptr; }
    SceneDescription& draft() { return draft_; }
    const SceneDescription& draft() const { return draft_; }
    const Camera& cameraOfFile() const { return cameraOfFile_; }
    const Bounds& bounds() const { return bounds_; }
    void adopt(SceneDescription scene);
    /// Loads in the background. A scene that cannot be opened sets openError() and changes nothing else. Of
    /// several asked for at once, the last counts.
    void open(const std::string& path);
    bool opening() const { return opening_; }
    const std::optional<Error>& openError() const { return openError_; }
    void dismissOpenError() { openError_.reset(); }
    /// The draft uses a texture, mesh or environment image that was left on the disk: it is being read in the
    /// background, and what needs it is posted when it is there.
    bool readingAssets() const { return readingAssets_; }
    /// Why the last of them could not be read; the draft is back at what it had before.
    const std::optional<Error>& assetError() const { return assetError_; }
    void dismissAssetError() { assetError_.reset(); }

    // Rendering.
    RenderSession& session() { return session_; }
    StopLimits limits;
    bool paused = false;
    void restart();

    // Files; each logs how it ended.
    void savePng();
    void saveExr();
    void saveCheckpointFile();
    void resumeCheckpoint();
    void saveSceneFile();
    /// The curves of both integrators as a table (convergence_csv.h).
    void saveConvergenceCsv();
    /// A file that was dropped on the window: a picture becomes the reference, a checkpoint (.glintfilm) is
    /// resumed, anything else is opened as a scene.
    void takeDroppedFile(const std::string& path);
    /// The result of the last save, load or resume, for the panel.
    const std::string& fileMessage() const { return fileMessage_; }
    bool fileMessageIsError() const { return fileMessageIsError_; }
    /// The same of the last saveConvergenceCsv().
    const std::string& csvMessage() const { return csvMessage_; }
    bool csvMessageIsError() const { return csvMessageIsError_; }
    bool busy() const {
        return jobs_.running() > 0 || pendingExr_ || reference.loading() || reference.measuring();
    }
    /// Looks up the first dropped sample and makes the command line that replays it.
    void findFault();
    const std::string& replayCommand() const { return replayCommand_; }

    // Once a frame: first refresh(), then the panels, then commitEdits().
    void refresh();
    /// `held`: the user is holding a control or the camera, so passes run at low resolution until
    /// finishMotion(). Returns what was posted.
    EditKind commitEdits(bool held);
    void finishMotion();
    const SessionStatus& status() const { return status_; }
    const std::shared_ptr<const FilmSnapshot>& snapshot() const { return snapshot_; }
    /// While the picture is split: the integrator that snapshot() does not show; null before its first pass.
    const std::shared_ptr<const FilmSnapshot>& otherSnapshot() const { return otherSnapshot_; }
    /// The film is at full resolution and belongs to the scene as it is now.
    bool imageIsCurrent() const;
    /// The snapshots carry what DisplaySettings::shown asks for.
    bool carriesShownImage() const;
    /// An edit was posted, or waits for a file, and no picture of it has come back.
    bool awaitsEdit() const { return awaitedEdit_ != 0 || readingAssets_; }

    /// The estimate of the error so far, whether this integrator is shown or not. Never null.
    const std::shared_ptr<const ConvergenceCurve>& curve(IntegratorKind kind) const {
        return curves_[static_cast<size_t>(kind)];
    }

    /// That of the film before the last restart, if it had more than a few points. Never null.
    const std::shared_ptr<const ConvergenceCurve>& curveBefore(IntegratorKind kind) const {
        return curvesBefore_[static_cast<size_t>(kind)];
    }

    DisplaySettings display;
    /// Set by who draws: what is on the screen is not of the newest snapshots yet.
    bool displayIsBehind = false;
    ConvergenceSettings convergence;
    ReferenceErrors reference;
    ReferenceFit referenceFit;
    /// The reference where errors may be measured against it: it has the picture's size, and shows the scene
    /// as it is now (or the user vouches for it). Null otherwise, and without one.
    std::shared_ptr<const LoadedReference> usableReference() const;
    FileSettings files;
    bool focusFollowsTarget = true;
    int selectedMaterial = 0;
    int selectedLight = 0;

  private:
    using Capture = RenderSession::Capture;
    void readAssets();
    void takeReadAssets(const SceneDescription& asked, const CompletedScene& read);
    /// What is shown of the curves, and the snapshots' errors against the reference.
    void refreshConvergence();
    void refreshOther();
    void takeCurve(IntegratorKind kind);
    /// Limits, pause and extra pictures.
    void postRequest();
    /// Takes the film when the pass in flight is done, then runs `save` on it, both in the background.
    void saveCaptured(const std::string& path, std::function<Status(const Capture&)> save);
    void startExr();
    void tellOfReference();
    void finishFileJob(const Status& result, const std::string& success);
    void autosave();

    SceneDescription draft_;
    std::shared_ptr<const SceneDescription> posted_;
    Camera cameraOfFile_;
    Bounds bounds_;
    bool opening_ = false;
    std::string openNext_;  ///< asked for while another scene was being opened
    std::optional<Error> openError_;
    uint64_t adoptions_ = 0;
    bool readingAssets_ = false;
    std::optional<Error> assetError_;

    JobQueue jobs_;  // before the session, whose end answers the jobs that wait for a picture
    RenderSession session_;
    SessionStatus status_;
    std::shared_ptr<const FilmSnapshot> snapshot_;
    std::shared_ptr<const FilmSnapshot> otherSnapshot_;
    std::array<std::shared_ptr<const ConvergenceCurve>, 2> curves_;
    std::array<std::shared_ptr<const ConvergenceCurve>, 2> curvesBefore_;
    bool isAnotherScene_ = false;  ///< the curves may still be of the one before
    RenderRequest request_;
    EditTicket awaitedEdit_ = 0;  ///< 0: every edit has been answered

    bool pendingExr_ = false;
    std::string fileMessage_;
    bool fileMessageIsError_ = false;
    std::string csvMessage_;
    bool csvMessageIsError_ = false;
    std::string replayCommand_;
    double lastAutosave_ = 0.0;
};

}  // namespace glint

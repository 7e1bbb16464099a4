// Numbered pictures of a camera that moves, rendered beside the window: the live picture waits meanwhile, and
// goes on where it was.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "engine/render/render_session.h"
#include "viewer/base/camera_bookmarks.h"
#include "viewer/base/camera_way.h"
#include "viewer/base/job_queue.h"
#include "viewer/base/numbered_files.h"
#include "viewer/base/run_files.h"
#include "viewer/model/backend_maker.h"
#include "viewer/model/display_settings.h"
#include "viewer/model/notice.h"
#include "viewer/model/overwrite_guard.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"

namespace glint {

class FrameSeries {
  public:
    FrameSeries(JobQueue* jobs, const SceneDocument* document, const RenderControl* render,
                const CameraBookmarks* bookmarks, Notice* notice, const RunFiles* inputs,
                OverwriteGuard* guard)
        : jobs_(jobs),
          document_(document),
          render_(render),
          bookmarks_(bookmarks),
          notice_(notice),
          inputs_(inputs),
          guard_(guard) {}
    ~FrameSeries() { cancel(); }
    FrameSeries(const FrameSeries&) = delete;
    FrameSeries& operator=(const FrameSeries&) = delete;

    BackendMaker makeBackend;  ///< what renders them; set before the first

    bool isFlight = false;  ///< through the bookmarks of the scene; otherwise a turn around the target
    int images = 36;
    int passes = 64;       ///< of each; 0: no limit
    float seconds = 0.0f;  ///< likewise
    std::string folder = "turntable";

    /// Renders the scene as it is now, as the display shows it, to FOLDER/frame-000001.png and so on; asks
    /// before files are replaced.
    void start(const DisplaySettings& display);
    /// After the tile in flight; whole pictures stay.
    void cancel();
    bool isRunning() const { return work_ != nullptr; }
    /// "3 of 36, 12 passes", and the share of all pictures that is done.
    std::string progressText() const;
    float progress() const;

    /// What start() would say is missing; "": nothing.
    std::string missing() const;
    /// What stands in the camera's way (camera_way.h), found out while nothing moves.
    const std::string& obstacles();

  private:
    /// Shared with the job.
    struct Work {
        std::atomic<bool> isCancelled = false;
        std::atomic<uint32_t> done = 0;    ///< pictures
        std::atomic<uint32_t> passes = 0;  ///< of the picture in flight
        uint32_t images = 0;
    };
    struct Job;
    static Status render(const Job& job);
    static Status renderWithMemory(const Job& job);
    CameraWay way() const;
    NumberedFiles files() const;
    Status checkFiles() const;
    void launch(const DisplaySettings& display);

    JobQueue* jobs_;
    const SceneDocument* document_;
    const RenderControl* render_;
    const CameraBookmarks* bookmarks_;
    Notice* notice_;
    const RunFiles* inputs_;
    OverwriteGuard* guard_;
    std::shared_ptr<Work> work_;  ///< null: none is under way

    struct WayOf {
        std::shared_ptr<const BuiltScene> built;
        int images = 0;
        size_t views = 0;  ///< of a flight; 0: a turn

        bool operator==(const WayOf&) const = default;
    };
    WayOf obstaclesOf_;
    std::string obstacles_;
};

}  // namespace glint

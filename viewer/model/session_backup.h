// A checkpoint that is saved again and again while the window is open, and offered by the next start when
// this one does not come to its end: scene, edits and film.
//
// Each session has a file of its own and locks it, so that no start takes another window's for a leftover.
// Lives on the UI thread; reading and saving are jobs.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/base/job_queue.h"
#include "viewer/model/notice.h"
#include "viewer/model/render_control.h"
#include "viewer/model/scene_document.h"

namespace glint {

/// The files that a scene held in memory stand in a folder beside its session's checkpoint `file`, and are
/// taken into memory again. Of other checkpoints: nothing.
void restoreBeside(const std::string& file, SceneDescription* scene);

class SessionBackup {
  public:
    SessionBackup(const SceneDocument* document, RenderControl* render, Notice* notice)
        : document_(document), render_(render), notice_(notice) {}
    /// The session has come to its end: its file is removed, but for keep().
    ~SessionBackup();
    SessionBackup(const SessionBackup&) = delete;
    SessionBackup& operator=(const SessionBackup&) = delete;

    /// Looks for what others left in `folder`, and saves there every so many seconds. A folder that cannot be
    /// written is a warning.
    void begin(const std::string& folder, double seconds);
    /// Once a frame.
    void refresh();
    /// For the next start, whatever the end of this session.
    void keep() { isKept_ = true; }

    struct Leftover {
        std::string file;
        std::string scenePath;
        uint32_t passes = 0;
    };
    /// The newest; null: there is none.
    const Leftover* leftover() const { return leftovers_.empty() ? nullptr : &leftovers_.back().info; }
    /// The leftover is this session's file from now on; returns its name, to be opened.
    std::string takeOver();
    void discard();

  private:
    struct Locked {
        Leftover info;
        int lock = -1;
    };
    void findLeftovers(const std::string& folder);
    /// It may be of another version of the program, which can read it.
    void setAside(const std::string& file, int lock, const Error& why);
    void save();
    /// Says it when saving begins to fail, and not again until it has worked.
    void noteSaved(const Status& saved);

    const SceneDocument* document_;
    RenderControl* render_;
    Notice* notice_;
    std::unique_ptr<JobQueue> jobs_ = std::make_unique<JobQueue>();
    std::string file_;
    int lock_ = -1;
    double interval_ = 0.0;
    double lastSaved_ = 0.0;
    bool isSaving_ = false;
    bool isFailing_ = false;
    bool isKept_ = false;
    std::shared_ptr<const SceneDescription> savedScene_;
    uint32_t savedPasses_ = 0;
    std::vector<Locked> leftovers_;  ///< the newest last
};

}  // namespace glint

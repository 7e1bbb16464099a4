// Scenes in and out of files, in the background.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "engine/io/load_options.h"
#include "engine/io/scene_choices.h"
#include "engine/scene/scene.h"
#include "viewer/base/job_queue.h"
#include "viewer/base/run_files.h"
#include "viewer/model/file_dialog.h"
#include "viewer/model/notice.h"
#include "viewer/model/overwrite_guard.h"
#include "viewer/model/recent_files.h"

namespace glint {

/// How a file was read, and what it lets its user choose.
struct SceneReading {
    std::string path = {};
    LoadOptions options = {};
    SceneChoices choices = {};
    bool isStale = false;  ///< the options have been changed since
};

class SceneFiles {
  public:
    using Adopt = std::function<void(SceneDescription)>;
    using NoteSaved = std::function<void(const std::shared_ptr<const SceneDescription>&)>;
    /// `adopt` takes a scene that was loaded, `add` one whose objects are to be added, `noteSaved` hears of
    /// one that was saved.
    SceneFiles(JobQueue* jobs, Notice* notice, const RunFiles* inputs, OverwriteGuard* guard, Adopt adopt,
               Adopt add, NoteSaved noteSaved)
        : dialog(jobs),
          jobs_(jobs),
          notice_(notice),
          inputs_(inputs),
          guard_(guard),
          adopt_(std::move(adopt)),
          add_(std::move(add)),
          noteSaved_(std::move(noteSaved)) {}

    std::string opened;                ///< the file that is shown, or will be asked for next
    std::string saved = "scene.json";  ///< where save() writes

    /// A scene that cannot be opened sets error() and changes nothing else. Of several asked for at once, the
    /// last counts.
    void open(const std::string& path);
    bool opening() const { return opening_; }
    /// The same of the scene that is shown, whose file has changed, or is to be read in another way.
    void reload(const std::string& path);
    bool reloading() const { return isReload_; }
    /// Of the scene that was opened last. Its file is read with the same options again, any other without.
    SceneReading reading;
    /// Hands the scene in that file to who adds its objects to the one that is open.
    void add(const std::string& path);
    const std::optional<Error>& error() const { return error_; }
    void dismissError() {
        error_.reset();
        part_.reset();
    }
    /// The scene that could not be opened lacks files alone, and can be without them.
    bool opensWithoutFiles() const { return part_ != nullptr; }
    /// Opens it so; what is left out is among the scene's warnings.
    void openWithoutFiles();

    /// Lets the user look for a scene.
    void browse();
    RecentFiles recent;

    /// As Glint JSON. `scene` may be null, which is an error. Asks before it replaces a file.
    void save(const std::shared_ptr<const SceneDescription>& scene);
    /// The same after the user has said where.
    void saveAs(const std::shared_ptr<const SceneDescription>& scene);

    FileDialog dialog;

  private:
    void startSave(const std::string& path, const std::shared_ptr<const SceneDescription>& scene);

    JobQueue* jobs_;
    Notice* notice_;
    const RunFiles* inputs_;
    OverwriteGuard* guard_;
    Adopt adopt_;
    Adopt add_;
    NoteSaved noteSaved_;
    bool opening_ = false;
    bool isReload_ = false;
    std::string next_;  ///< asked for while another scene was being opened
    std::optional<Error> error_;
    std::shared_ptr<SceneDescription> part_;  ///< of the scene that error_ is of; null: there is none
};

}  // namespace glint

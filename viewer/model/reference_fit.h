// Whether the loaded reference shows the scene as it is now: an error against another picture is no error.
//
// A reference that names its scene (the EXR files of Glint do) is held against that name. Any other counts as
// a picture of the scene as it was when it was loaded. Edits are compared at once; fingerprints, which read
// every triangle and texel, are formed on a thread of their own. Lives on the UI thread and draws nothing.
#pragma once

#include <memory>
#include <string>

#include "engine/scene/scene.h"
#include "viewer/base/job_queue.h"
#include "viewer/model/reference_errors.h"

namespace glint {

class ReferenceFit {
  public:
    /// Once a frame. Either may be null. `mayHash`: not while something is dragged.
    void check(const std::shared_ptr<const LoadedReference>& reference,
               const std::shared_ptr<const SceneDescription>& scene, bool mayHash);

    /// The user vouches for it, whatever seems to be different. Forgotten with the reference.
    bool useAnyway = false;

    /// Both are there, and nothing is known to be different.
    bool fits() const { return scene_ && scene_ == checked_ && difference_.empty(); }
    /// The answer for the scene of the last check() is not known yet.
    bool checking() const { return reference_ && scene_ && scene_ != checked_; }
    /// What is different, as a clause: "the camera has changed"; of the answer before while checking().
    const std::string& difference() const { return difference_; }

  private:
    using Scene = std::shared_ptr<const SceneDescription>;
    bool namesItsScene() const;
    void answer(const Scene& scene, std::string difference);
    void startHash();

    JobQueue jobs_;
    bool hashing_ = false;
    std::shared_ptr<const LoadedReference> reference_;
    Scene scene_;
    Scene checked_;  ///< what difference_ is the answer for
    Scene known_;    ///< a scene that the reference shows; null: none was met yet
    std::string difference_;
};

}  // namespace glint

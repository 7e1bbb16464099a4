// Reads what the draft uses and was left on the disk: textures, environment images, meshes for their texture
// coordinates. In the background; edits that need none of it go on meanwhile.
#pragma once

#include <optional>
#include <utility>

#include "engine/base/result.h"
#include "viewer/base/job_queue.h"
#include "viewer/model/notice.h"
#include "viewer/model/scene_document.h"

namespace glint {

struct CompletedScene;

class AssetReader {
  public:
    AssetReader(JobQueue* jobs, SceneDocument* document, Notice* notice)
        : jobs_(jobs), document_(document), notice_(notice) {}

    /// Starts unless it is under way. The draft gets what was read; where a file cannot be used it gets back
    /// what it had before.
    void read();
    bool reading() const { return reading_; }
    /// True once after a reading has ended: the draft is to be posted.
    bool takeArrival() { return std::exchange(arrived_, false); }
    /// Another scene was adopted.
    void forget();

    /// Why the last of them could not be read.
    const std::optional<Error>& error() const { return error_; }
    void dismissError() { error_.reset(); }

  private:
    void take(const SceneDescription& asked, const CompletedScene& read);

    JobQueue* jobs_;
    SceneDocument* document_;
    Notice* notice_;
    bool reading_ = false;
    bool arrived_ = false;
    std::optional<Error> error_;
};

}  // namespace glint

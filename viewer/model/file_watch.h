// Notices when files that a scene was read from are changed by another program.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// Absolute paths of all of sceneFiles() (used_assets.h).
std::vector<std::string> filesOf(const SceneDescription& scene);

class FileWatch {
  public:
    /// From how they are now.
    void watch(const std::vector<std::string>& paths);
    /// True once after one of them has changed and then stayed as it is for a look: a writer may be in the
    /// middle. A file that is gone is waited for. `now`: seconds of any clock; looks no more than twice a
    /// second, at so many files that a frame does not notice: of thousands, in turn.
    bool hasChanged(double now);

  private:
    struct Seen {
        std::filesystem::file_time_type time;
        std::uintmax_t bytes = 0;
        bool isThere = false;
        bool operator==(const Seen&) const = default;
    };
    static Seen look(const std::string& path);

    std::vector<std::string> paths_;
    std::vector<Seen> known_;
    std::vector<Seen> before_;  ///< at the last look
    size_t next_ = 0;           ///< the file to look at first
    double lastLook_ = 0.0;
};

}  // namespace glint

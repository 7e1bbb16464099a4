#include "viewer/base/checkpoint_file.h"

#include <filesystem>
#include <utility>

#include <fmt/format.h>
#include <sys/stat.h>

#include "engine/base/log.h"

namespace glint {

std::string freeNameBeside(const std::string& path) {
    const std::filesystem::path given(path);
    for (int number = 2;; ++number) {
        const std::filesystem::path name =
            given.parent_path() /
            fmt::format("{}-{}{}", given.stem().string(), number, given.extension().string());
        if (!std::filesystem::exists(name)) { return name.string(); }
    }
}

CheckpointFile::Stamp CheckpointFile::stampOf(const std::string& path) {
    struct stat info {};
    if (::stat(path.c_str(), &info) != 0 || !S_ISREG(info.st_mode) || info.st_size == 0) {
        return std::nullopt;
    }
    return std::tuple(uint64_t{info.st_dev}, uint64_t{info.st_ino},
                      int64_t{info.st_mtim.tv_sec} * 1'000'000'000 + info.st_mtim.tv_nsec);
}

CheckpointFile::CheckpointFile(std::string path, bool overwrite)
    : path_(std::move(path)), overwrite_(overwrite), known_(stampOf(path_)) {
    if (!known_ || overwrite_) { return; }
    if (auto info = readCheckpointInfo(path_)) { atFirst_ = std::move(*info); }
}

std::string CheckpointFile::reasonToKeep(const SessionCapture& capture) const {
    const Stamp now = stampOf(path_);
    if (now && now != known_) { return "was written by another render meanwhile"; }
    if (!atFirst_) { return ""; }
    if (capture.film.passes() < atFirst_->passes) { return "holds a longer film"; }
    return isOfScene(*atFirst_, *capture.scene) ? "" : "holds a film of another scene";
}

Status CheckpointFile::save(const SessionCapture& capture) {
    if (path_.empty()) { return {}; }
    if (const std::string reason = overwrite_ ? "" : reasonToKeep(capture); !reason.empty()) {
        const std::string free = freeNameBeside(path_);
        logWarning("{} {}; this film is saved as {}", path_, reason, free);
        path_ = free;
    }
    Status saved = saveCheckpoint(path_, capture);
    if (saved) {
        known_ = stampOf(path_);
        atFirst_.reset();
    }
    return saved;
}

}  // namespace glint

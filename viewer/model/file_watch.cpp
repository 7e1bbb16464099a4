#include "viewer/model/file_watch.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

#include "engine/io/used_assets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;
constexpr double kSecondsBetweenLooks = 0.5;
constexpr size_t kMostLooks = 256;

}  // namespace

std::vector<std::string> filesOf(const SceneDescription& scene) {
    std::vector<std::string> paths;
    std::error_code problem;
    for (const SceneFile& file : sceneFiles(scene)) {
        paths.push_back(fs::absolute(file.path, problem).lexically_normal().string());
    }
    std::ranges::sort(paths);
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

FileWatch::Seen FileWatch::look(const std::string& path) {
    std::error_code problem;
    Seen seen;
    seen.time = fs::last_write_time(path, problem);
    seen.isThere = !problem;
    if (seen.isThere) { seen.bytes = fs::file_size(path, problem); }
    return seen.isThere ? seen : Seen{};
}

void FileWatch::watch(const std::vector<std::string>& paths) {
    paths_ = paths;
    next_ = 0;
    known_.clear();
    std::ranges::transform(paths_, std::back_inserter(known_), look);
    before_ = known_;
}

bool FileWatch::hasChanged(double now) {
    if (now - lastLook_ < kSecondsBetweenLooks || paths_.empty()) { return false; }
    lastLook_ = now;
    bool isStill = true, isComplete = true, isOther = false;
    for (size_t count = std::min(paths_.size(), kMostLooks); count > 0; --count) {
        const size_t i = std::exchange(next_, (next_ + 1) % paths_.size());
        const Seen seen = look(paths_[i]);
        isStill = std::exchange(before_[i], seen) == seen && isStill;
        isComplete = (seen.isThere || !known_[i].isThere) && isComplete;
        isOther = isOther || !(seen == known_[i]);
    }
    if (!isStill || !isComplete || !isOther) { return false; }
    known_ = before_;
    return true;
}

}  // namespace glint

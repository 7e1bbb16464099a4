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

std::vector<FileWatch::Seen> FileWatch::lookAtAll() const {
    std::vector<Seen> all;
    std::ranges::transform(paths_, std::back_inserter(all), look);
    return all;
}

void FileWatch::watch(const std::vector<std::string>& paths) {
    paths_ = paths;
    known_ = before_ = lookAtAll();
}

bool FileWatch::hasChanged(double now) {
    if (now - lastLook_ < kSecondsBetweenLooks || paths_.empty()) { return false; }
    lastLook_ = now;
    std::vector<Seen> seen = lookAtAll();
    const bool isStill = std::exchange(before_, seen) == seen;
    const bool isComplete = std::ranges::all_of(seen, [&](const Seen& each) {
        return each.isThere || !known_[static_cast<size_t>(&each - seen.data())].isThere;
    });
    if (!isStill || !isComplete || seen == known_) { return false; }
    known_ = std::move(seen);
    return true;
}

}  // namespace glint

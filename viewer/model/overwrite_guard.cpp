#include "viewer/model/overwrite_guard.h"

#include <filesystem>
#include <utility>

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string fullName(const std::string& path) {
    std::error_code problem;
    const fs::path full = fs::weakly_canonical(path, problem);
    return problem ? path : full.string();
}

/// Devices and pipes lose nothing.
bool holdsSomething(const std::string& path) {
    std::error_code problem;
    return fs::is_regular_file(path, problem) && fs::file_size(path, problem) > 0;
}

}  // namespace

bool OverwriteGuard::mustAsk(const std::string& path) const {
    return holdsSomething(path) && !ours_.contains(fullName(path));
}

void OverwriteGuard::save(const std::string& path, std::function<void()> save) {
    refuse();
    if (mustAsk(path)) {
        asked_ = path;
        save_ = std::move(save);
        return;
    }
    mayReplace(path);
    save();
}

void OverwriteGuard::mayReplace(const std::string& path) { ours_.insert(fullName(path)); }

void OverwriteGuard::agree() {
    mayReplace(asked_);
    const std::function<void()> save = std::exchange(save_, nullptr);
    asked_.clear();
    if (save) { save(); }
}

void OverwriteGuard::refuse() {
    asked_.clear();
    save_ = nullptr;
}

}  // namespace glint

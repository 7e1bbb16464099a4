#include "viewer/model/overwrite_guard.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <utility>

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string fullName(const std::string& path) {
    std::error_code problem;
    // The name of a file that is not there yet would stay relative.
    const fs::path full = fs::weakly_canonical(fs::absolute(path, problem), problem);
    return problem ? path : full.string();
}

/// Devices and pipes lose nothing.
bool holdsSomething(const std::string& path) {
    std::error_code problem;
    return fs::is_regular_file(path, problem) && fs::file_size(path, problem) > 0;
}

}  // namespace

bool OverwriteGuard::mustAsk(const std::string& path, const std::string& of) const {
    const auto own = ours_.find(fullName(path));
    return holdsSomething(path) && (own == ours_.end() || own->second != of);
}

void OverwriteGuard::save(const std::string& path, std::function<void()> save, const std::string& of) {
    refuse();
    if (mustAsk(path, of)) {
        asked_ = {path};
        askedOf_ = of;
        save_ = std::move(save);
        return;
    }
    mayReplace(path, of);
    save();
}

void OverwriteGuard::save(const std::vector<std::string>& paths, std::function<void()> save) {
    refuse();
    std::ranges::copy_if(paths, std::back_inserter(asked_),
                         [this](const std::string& path) { return mustAsk(path); });
    if (asked_.empty()) { return save(); }
    askedOf_.clear();
    save_ = std::move(save);
}

void OverwriteGuard::mayReplace(const std::string& path, const std::string& of) {
    ours_[fullName(path)] = of;
}

void OverwriteGuard::agree() {
    std::ranges::for_each(asked_, [this](const std::string& path) { mayReplace(path, askedOf_); });
    const std::function<void()> save = std::exchange(save_, nullptr);
    asked_.clear();
    if (save) { save(); }
}

void OverwriteGuard::refuse() {
    asked_.clear();
    save_ = nullptr;
}

}  // namespace glint

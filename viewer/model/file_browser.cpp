#include "viewer/model/file_browser.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <tuple>

#include "viewer/base/typed_path.h"

namespace glint {

namespace fs = std::filesystem;

void FileBrowser::open(const std::string& path) {
    std::error_code problem;
    const fs::path given = fs::absolute(typedPath(path), problem).lexically_normal();
    isOpen_ = true;
    typed.clear();
    list(fs::is_directory(given, problem) ? given.string() : given.parent_path().string());
}

void FileBrowser::list(const std::string& folder) {
    folder_ = folder;
    entries_.clear();
    std::error_code problem;
    for (const auto& entry :
         fs::directory_iterator(folder, fs::directory_options::skip_permission_denied, problem)) {
        const std::string name = entry.path().filename().string();
        const bool isFolder = entry.is_directory(problem);
        if (!name.starts_with(".")) { entries_.push_back({isFolder ? name + "/" : name, isFolder}); }
    }
    std::ranges::sort(entries_, [](const Entry& a, const Entry& b) {
        return std::tuple(!a.isFolder, a.name) < std::tuple(!b.isFolder, b.name);
    });
    entries_.insert(entries_.begin(), {"../", true});
}

std::string FileBrowser::choose(const std::string& name) {
    std::error_code problem;
    fs::path path = (fs::path(folder_) / typedPath(name)).lexically_normal();
    if (!path.has_filename()) { path = path.parent_path(); }
    if (fs::is_directory(path, problem)) {
        typed.clear();
        list(path.string());
        return "";
    }
    return path.string();
}

}  // namespace glint

#include "viewer/model/recent_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "engine/io/atomic_file.h"

namespace glint {

void RecentFiles::begin(const std::string& file) {
    file_ = file;
    std::ifstream in(file);
    for (std::string line; std::getline(in, line) && paths_.size() < kMost;) {
        if (!line.empty()) { paths_.push_back(line); }
    }
}

void RecentFiles::add(const std::string& path) {
    std::error_code problem;
    const std::filesystem::path absolute = std::filesystem::absolute(path, problem).lexically_normal();
    if (path.empty() || problem || absolute.string().find('\n') != std::string::npos) { return; }
    std::erase(paths_, absolute.string());
    paths_.insert(paths_.begin(), absolute.string());
    paths_.resize(std::min(paths_.size(), kMost));
    if (file_.empty()) { return; }
    std::string text;
    for (const std::string& each : paths_) {
        text += each + "\n";
    }
    std::filesystem::create_directories(std::filesystem::path(file_).parent_path(), problem);
    (void)writeFileAtomically(file_, text);  // a comfort, and no reason for a message
}

}  // namespace glint

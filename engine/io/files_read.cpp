#include "engine/io/files_read.h"

#include <algorithm>
#include <utility>

namespace glint {

thread_local FilesRead* FilesRead::current_ = nullptr;

FilesRead::FilesRead() : outer_(std::exchange(current_, this)) {}

FilesRead::~FilesRead() { current_ = outer_; }

std::vector<std::string> FilesRead::paths() const {
    std::vector<std::string> paths = paths_;
    std::ranges::sort(paths);
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

void FilesRead::note(const std::string& path) {
    for (FilesRead* each = current_; each != nullptr; each = each->outer_) {
        each->paths_.push_back(path);
    }
}

}  // namespace glint

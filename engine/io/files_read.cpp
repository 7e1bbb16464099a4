#include "engine/io/files_read.h"

#include <algorithm>
#include <utility>

namespace glint {

namespace {

thread_local FilesRead* innermost = nullptr;

}  // namespace

FilesRead::FilesRead() : outer_(std::exchange(innermost, this)) {}

FilesRead::~FilesRead() { innermost = outer_; }

std::vector<std::string> FilesRead::paths() const {
    std::vector<std::string> paths = paths_;
    std::ranges::sort(paths);
    paths.erase(std::unique(paths.begin(), paths.end()), paths.end());
    return paths;
}

void FilesRead::note(const std::string& path) {
    for (FilesRead* each = innermost; each != nullptr; each = each->outer_) {
        each->paths_.push_back(path);
    }
}

}  // namespace glint

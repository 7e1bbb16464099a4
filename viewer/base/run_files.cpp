#include "viewer/base/run_files.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <tuple>

#include <fmt/format.h>
#include <sys/stat.h>

#include "engine/io/atomic_file.h"
#include "engine/io/file_kind.h"
#include "engine/io/file_path.h"
#include "engine/io/used_assets.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

/// Device, number, and the name in the folder that these are of where the file is not there yet.
using FileIdentity = std::tuple<dev_t, ino_t, std::string>;

/// Nothing for devices, pipes and what can be no file.
std::optional<FileIdentity> identityOf(const std::string& path) {
    if (path.empty()) { return std::nullopt; }
    struct stat info {};
    if (::stat(path.c_str(), &info) == 0) {
        return S_ISREG(info.st_mode) ? std::optional(FileIdentity{info.st_dev, info.st_ino, ""})
                                     : std::nullopt;
    }
    const fs::path target(followLinks(path));
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    if (::stat(folder.c_str(), &info) != 0) { return std::nullopt; }
    return FileIdentity{info.st_dev, info.st_ino, target.filename().string()};
}

}  // namespace

bool isSameFile(const std::string& a, const std::string& b) {
    const auto identity = identityOf(a);
    return identity && identity == identityOf(b);
}

void RunFiles::reads(const std::string& what, const std::string& path) {
    const bool isKnown = std::ranges::find(inputs_, path, &Input::path) != inputs_.end();
    if (!path.empty() && !isKnown) { inputs_.push_back({what, path}); }
}

void RunFiles::readsScene(const SceneDescription& scene) {
    for (const SceneFile& file : sceneFiles(scene)) {
        reads(file.what, file.path);
    }
}

Status RunFiles::writes(const std::string& path) {
    if (path.empty() || path == "-") { return {}; }
    if (Status free = checkIsNoOutput(path); !free) { return free; }
    outputs_.push_back(path);
    if (Status writable = checkWritable(path); !writable) { return writable; }
    return checkIsNoInput(path);
}

Status RunFiles::checkIsFree(const std::string& path) const {
    const Status free = checkIsNoOutput(path);
    return free ? checkIsNoInput(path) : free;
}

Status RunFiles::checkCanWrite(const std::string& path) const {
    const Status free = checkIsFree(path);
    return free ? checkWritable(path) : free;
}

Status RunFiles::checkCanWrite(const NumberedFiles& images) const {
    std::vector<std::string> suspects = images.shared();
    const auto compareWith = [&](const std::string& other) {
        const uint32_t number = images.numberOf(fs::path(followLinks(other)).filename().string());
        if (number > 0) { suspects.push_back(numberedPath(images.path, number)); }
    };
    std::ranges::for_each(inputs_, compareWith, &Input::path);
    std::ranges::for_each(outputs_, compareWith);
    for (const std::string& suspect : suspects) {
        if (Status writable = checkCanWrite(suspect); !writable) { return writable; }
    }
    return {};
}

Status RunFiles::checkIsNoOutput(const std::string& path) const {
    const bool isTaken =
        std::ranges::any_of(outputs_, [&](const std::string& other) { return isSameFile(path, other); });
    if (!isTaken) { return {}; }
    return Error{fmt::format("two outputs go to one file, '{}'; expected different names", path), {}};
}

Status RunFiles::check() const {
    for (const std::string& output : outputs_) {
        if (Status isNone = checkIsNoInput(output); !isNone) { return isNone; }
    }
    return {};
}

Status RunFiles::checkIsNoInput(const std::string& path) const {
    if (path.empty()) { return Error{"there is no file name to save to; expected one", {}}; }
    for (const Input& input : inputs_) {
        if (isSameFile(path, input.path)) {
            return Error{fmt::format("is {}, which is read; expected another name to write to", input.what),
                         {.file = path}};
        }
    }
    return {};
}

Status RunFiles::checkHoldsNoInput(const std::string& folder) const {
    std::error_code ignored;
    for (const Input& input : inputs_) {
        fs::path parent = fs::weakly_canonical(input.path, ignored).parent_path();
        for (; parent.has_relative_path(); parent = parent.parent_path()) {
            if (!fs::equivalent(parent, folder, ignored)) { continue; }
            return Error{
                fmt::format("holds {}, which is read; expected another folder to write to", input.what),
                {.file = folder}};
        }
    }
    return {};
}

bool isOnlyEnding(const std::string& path) {
    const std::string name = fs::path(path).filename().string();
    return name.size() > 1 && name.rfind('.') == 0;
}

Status checkReplaces(const std::string& path, bool (*mayReplace)(std::string_view head),
                     std::string_view kind) {
    std::error_code ignored;
    const bool isThere = fs::is_regular_file(path, ignored) && fs::file_size(path, ignored) > 0;
    if (!isThere || mayReplace(readHead(path))) { return {}; }
    return Error{
        fmt::format("is there already and is not {}, so it is not replaced; expected another name", kind),
        {.file = path}};
}

}  // namespace glint

#include "viewer/base/camera_bookmarks.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "engine/io/atomic_file.h"
#include "engine/scene/kind_names.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string absolute(const std::string& path) {
    std::error_code problem;
    return fs::absolute(path, problem).lexically_normal().string();
}

/// Every number of a camera, in the file's order.
template <class AnyCamera, class Visit>
void forEachNumber(AnyCamera& camera, const Visit& visit) {
    for (auto* vector : {&camera.position, &camera.target, &camera.up}) {
        for (int i = 0; i < 3; ++i) {
            visit((*vector)[i]);
        }
    }
    visit(camera.verticalFovDeg);
    visit(camera.horizontalScale);
    visit(camera.apertureDiameter);
    visit(camera.focalDistance);
    visit(camera.apertureBlades);
    visit(camera.bladeRotationDeg);
}

/// At the end of the line; files from before cameras had it are read, too.
void readProjection(std::istringstream& words, Camera* camera) {
    std::string name;
    if (!(words >> name)) { return; }
    words >> camera->viewHeight >> camera->shift.x >> camera->shift.y;
    camera->kind = kindNamed<ProjectionKind>(name).value_or(ProjectionKind::Perspective);
}

}  // namespace

void CameraBookmarks::begin(const std::string& file) {
    file_ = file;
    std::ifstream in(file);
    // Three lines each: the scene, the name, the numbers.
    Bookmark read;
    for (std::string numbers;
         std::getline(in, read.scene) && std::getline(in, read.name) && std::getline(in, numbers);) {
        std::istringstream words(numbers);
        read.camera = {};
        forEachNumber(read.camera, [&](auto& number) { words >> number; });
        if (!words) { continue; }
        readProjection(words, &read.camera);
        all_.push_back(read);
    }
}

void CameraBookmarks::add(const std::string& scenePath, const Camera& camera) {
    int number = 0;
    for (const Bookmark& each : of(scenePath)) {
        number = std::max(number, std::atoi(each.name.c_str() + std::string("View ").size()));
    }
    all_.push_back({absolute(scenePath), fmt::format("View {}", number + 1), camera});
    save();
}

void CameraBookmarks::remove(const Bookmark& bookmark) {
    std::erase_if(all_, [&](const Bookmark& each) {
        return each.scene == bookmark.scene && each.name == bookmark.name;
    });
    save();
}

std::vector<CameraBookmarks::Bookmark> CameraBookmarks::of(const std::string& scenePath) const {
    std::vector<Bookmark> found;
    std::ranges::copy_if(all_, std::back_inserter(found),
                         [scene = absolute(scenePath)](const Bookmark& each) { return each.scene == scene; });
    return found;
}

void CameraBookmarks::save() const {
    if (file_.empty()) { return; }
    std::string text;
    for (const Bookmark& each : all_) {
        if (each.scene.find('\n') != std::string::npos) { continue; }
        text += each.scene + "\n" + each.name + "\n";
        forEachNumber(each.camera, [&](const auto& number) { text += fmt::format("{} ", number); });
        text += fmt::format("{} {} {} {}\n", nameOf(each.camera.kind), each.camera.viewHeight,
                            each.camera.shift.x, each.camera.shift.y);
    }
    std::error_code problem;
    fs::create_directories(fs::path(file_).parent_path(), problem);
    (void)writeFileAtomically(file_, text);  // a comfort, and no reason for a message
}

}  // namespace glint

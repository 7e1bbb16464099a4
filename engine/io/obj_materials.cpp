// Only materials and images that faces use are taken over; images are named here and read by others.
#include "engine/io/obj_materials.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/text_cursor.h"

namespace glint {
namespace {

namespace fs = std::filesystem;

std::string besideFile(const std::string& file, std::string name) {
    const fs::path folder = fs::path(file).parent_path();
    std::error_code ignored;
    if (!fs::exists(folder / name, ignored)) {
        std::replace(name.begin(), name.end(), '\\', '/');  // written on Windows
    }
    return (folder / name).string();
}

}  // namespace

/// A line is one file name with blanks, where such a file exists, else several names.
Status MaterialResolver::readLibraries(const std::vector<std::string>& lines) {
    std::set<std::string> read;
    for (const std::string& line : lines) {
        std::vector<std::string> names{line};
        std::error_code ignored;
        if (!fs::exists(besideFile(objPath_, line), ignored)) {
            names.clear();
            TextCursor cursor(line, objPath_);
            for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
                names.emplace_back(word);
            }
        }
        for (const std::string& name : names) {
            if (Status status = read.insert(name).second ? readLibrary(name) : Status(); !status) {
                return status;
            }
        }
    }
    return {};
}

Status MaterialResolver::readLibrary(const std::string& name) {
    const std::string path = besideFile(objPath_, name);
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        file_.warnings.push_back(fmt::format("{}: the material file \"{}\" is missing", objPath_, path));
        return {};
    }
    Result<std::vector<MtlMaterial>> materials = loadMtl(path, &file_.warnings);
    if (!materials) { return materials.error(); }
    for (MtlMaterial& mtl : *materials) {
        std::string key = mtl.material.name;
        found_.try_emplace(std::move(key), Found{std::move(mtl), path});
    }
    return {};
}

int MaterialResolver::indexOf(const std::string& name, const std::string& place) {
    if (const auto taken = taken_.find(name); taken != taken_.end()) { return taken->second; }
    Material material;
    if (const auto found = found_.find(name); found != found_.end()) {
        material = found->second.mtl.material;
        takeTexture(found->second, &material);
    } else {
        warnMissing(name, place);
        material.name = name.empty() ? "default" : name;
        material.color.value = Vec3(0.7f);
    }
    file_.materials.push_back(std::move(material));
    return taken_[name] = static_cast<int>(file_.materials.size()) - 1;
}

void MaterialResolver::warnMissing(const std::string& name, const std::string& place) {
    if (name.empty()) {
        return;  // the file asks for none
    }
    std::vector<std::string_view> known;
    for (const auto& [candidate, found] : found_) {
        known.push_back(candidate);
    }
    file_.warnings.push_back(fmt::format("{}: material \"{}\" is not defined{}; a grey one takes its place",
                                         place, name, didYouMean(name, known)));
}

void MaterialResolver::takeTexture(const Found& found, Material* material) {
    const MtlMaterial& mtl = found.mtl;
    if (mtl.colorMap.empty()) { return; }
    const std::string path = besideFile(found.library, mtl.colorMap);
    const std::string key = fmt::format("{}\n{} {}", path, mtl.colorMapScale.x, mtl.colorMapScale.y);
    if (const auto known = textures_.find(key); known != textures_.end()) {
        material->color.texture = known->second;
        return;
    }
    std::error_code ignored;
    if (!fs::exists(path, ignored)) {
        file_.warnings.push_back(
            fmt::format("{}: the image \"{}\" of material \"{}\" is missing; its Kd is used",
                        mtl.colorMapWarningPlace, path, material->name));
        return;
    }
    Texture texture;
    texture.name = mtl.colorMap;
    texture.image.source = FileSource{path};
    texture.scale = mtl.colorMapScale;
    file_.textures.push_back(std::move(texture));
    material->color.texture = textures_[key] = static_cast<int>(file_.textures.size()) - 1;
}

}  // namespace glint

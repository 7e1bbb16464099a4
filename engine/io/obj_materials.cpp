// Only materials and images that faces use are taken over; images are named here and read by others.
#include "engine/io/obj_materials.h"

#include <algorithm>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "engine/base/nearest_name.h"
#include "engine/io/bump_scale.h"
#include "engine/io/file_path.h"
#include "engine/io/text_cursor.h"
#include "engine/scene/kind_names.h"

namespace glint {
namespace {

/// A name without its comment, quotes and capitals: what remains where a file spells it in two ways.
std::string looseName(std::string_view name) {
    name = withoutComment(name);
    if (name.size() > 1 && name.front() == '"' && name.back() == '"') {
        name = name.substr(1, name.size() - 2);
    }
    std::string out(name);
    std::ranges::transform(
        out, out.begin(), [](char c) { return static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c); });
    return out;
}

/// "a (d 0.1), b (illum 7 with Ni 1.5) and 4 more".
std::string listed(const std::vector<std::string>& items) {
    constexpr size_t kShown = 8;
    std::string out;
    for (size_t i = 0; i < std::min(items.size(), kShown); ++i) {
        out += (i > 0 ? ", " : "") + items[i];
    }
    return items.size() > kShown ? fmt::format("{} and {} more", out, items.size() - kShown) : out;
}

/// That get a material of their own.
constexpr size_t kMostUnknown = 1000;

}  // namespace

/// A line is one file name with blanks, where such a file exists, else several names.
void MaterialResolver::readLibraries(const std::vector<std::string>& lines) {
    std::set<std::string> read;
    const auto place = [&] { return objPath_; };
    for (const std::string& line : lines) {
        std::vector<std::string> names{line};
        if (line.find(' ') != std::string::npos && !files_.find(line, objPath_)) {
            names.clear();
            TextCursor cursor(line, objPath_);
            for (std::string_view word = cursor.word(); !word.empty(); word = cursor.word()) {
                names.emplace_back(word);
            }
        }
        for (const std::string& name : names) {
            if (!read.insert(name).second) { continue; }
            const auto found = files_.find(name, objPath_);
            if (!found) {
                remarks_.add("material files are missing", place, name);
                continue;
            }
            if (found->isGuess) {
                remarks_.add("material files are taken for others of a like name", place, name);
            }
            readLibrary(found->path);
        }
    }
}

void MaterialResolver::readLibrary(const std::string& path) {
    Result<MtlLibrary> library = loadMtl(path);
    if (!library) {
        remarks_.add(
            "material files cannot be read", [&] { return path; }, library.error().message);
        return;
    }
    for (size_t i = 0; i < library->file.entries.size(); ++i) {
        const std::string& name = library->file.entries[i].name;
        looseNames_.try_emplace(looseName(name), name);
        found_.try_emplace(name, Found{libraries_.size(), i});
    }
    libraries_.push_back(std::move(*library));
}

bool MaterialResolver::defines(const std::string& material) const {
    return found_.contains(material) || looseNames_.contains(looseName(material));
}

const MaterialResolver::Found* MaterialResolver::findMaterial(const MeshPart& part) {
    if (const auto found = found_.find(part.materialName); found != found_.end()) { return &found->second; }
    if (part.materialName.empty()) { return nullptr; }
    const auto place = [&] { return fmt::format("{}:{}", objPath_, part.materialLine); };
    if (const auto loose = looseNames_.find(looseName(part.materialName)); loose != looseNames_.end()) {
        remarks_.add("materials are taken for others of a like name", place, part.materialName);
        return &found_.find(loose->second)->second;
    }
    remarks_.add("materials are not defined; a grey one takes their place", place, part.materialName, [&] {
        std::vector<std::string_view> known;
        for (const auto& [candidate, found] : found_) {
            known.push_back(candidate);
        }
        return didYouMean(part.materialName, known);
    });
    return nullptr;
}

int MaterialResolver::indexOf(const MeshPart& part) {
    const bool hasColors = !part.mesh->colors.empty();
    const std::string key = part.materialName + (hasColors ? "\nc" : "\n");
    if (const auto taken = taken_.find(key); taken != taken_.end()) { return taken->second; }
    const Found* found = findMaterial(part);
    if (found == nullptr && ++unknownCount_ > kMostUnknown) {
        const auto [same, isNew] = unknown_.try_emplace(hasColors, static_cast<int>(file_.materials.size()));
        if (isNew) {
            file_.materials.push_back(unknownMaterial(part));
            file_.materials.back().name = "other materials that are not defined";
        }
        return taken_[key] = same->second;
    }
    file_.materials.push_back(found != nullptr ? take(*found) : unknownMaterial(part));
    return taken_[key] = static_cast<int>(file_.materials.size()) - 1;
}

void MaterialResolver::makeRoom() {
    std::vector<std::string_view> names;
    for (const MeshPart& part : file_.parts) {
        names.emplace_back(part.materialName);
    }
    std::ranges::sort(names);
    const auto different = static_cast<size_t>(std::unique(names.begin(), names.end()) - names.begin());
    file_.materials.reserve(std::min(different, found_.size() + kMostUnknown) + kLateComers);
}

Material MaterialResolver::take(const Found& found) {
    MtlLibrary& library = libraries_[found.library];
    const MtlEntry& entry = library.file.entries[found.entry];
    MtlMaterial mtl = materialOf(entry, &library);
    Material& material = mtl.material;
    material.color.texture = takeTexture(mtl.color, library.path);
    material.emission.texture = takeTexture(mtl.emission, library.path);
    material.roughness.texture = takeTexture(mtl.roughness, library.path);
    if (material.roughness.texture >= 0) {  // else it is missing
        material.crossRoughness.texture = takeTexture(mtl.crossRoughness, library.path);
    }
    material.metallic.texture = takeTexture(mtl.metallic, library.path);
    material.bump.texture = takeTexture(mtl.height, library.path);
    material.bumpHeight = mtl.bumpFactor;
    material.normalMap.texture = takeTexture(mtl.normal, library.path);
    material.opacity.texture = takeTexture(mtl.opacity, library.path);
    const bool lacksColor = !mtl.color.file.empty() && material.color.texture < 0;
    if (lacksColor && isZero(material.color.value)) {
        material.color.value = Vec3(0.5f);
    }  // seen as going without
    if (material.emission.texture >= 0) {
        const float factor = maxComponent(material.emission.value);
        material.emissionStrength = factor > 0.0f ? factor : 1.0f;
        if (minComponent(material.emission.value) < factor) {
            const auto place = [&] { return fmt::format("{}:{}", library.path, mtl.emission.line); };
            remarks_.add("emission maps lose the colour of Ke", place, entry.name);
        }
        material.emission.value = Vec3(0.0f);  // where the image cannot be read
        material.emitsBothSides = true;
    } else if (!mtl.emission.file.empty()) {
        material.emission.value = Vec3(0.0f);  // a factor on what is missing
    }
    if (!mtl.glass.empty()) { glass_.push_back(fmt::format("{} ({})", entry.name, mtl.glass)); }
    if (!mtl.doubt.empty()) { opaque_.push_back(fmt::format("{} ({})", entry.name, mtl.doubt)); }
    return std::move(mtl.material);
}

/// Index into the file's textures, or -1.
int MaterialResolver::takeTexture(const MtlMap& map, const std::string& library) {
    if (map.file.empty()) { return -1; }
    const auto place = [&] { return fmt::format("{}:{}", library, map.line); };
    auto file = files_.find(map.file, library);
    if (!file) { file = files_.find(map.file, objPath_); }
    if (!file) {
        remarks_.add("images are missing; the material's own colour takes their place", place, map.file);
        return -1;
    }
    if (file->isGuess) { remarks_.add("images are taken for others of a like name", place, map.file); }
    const Texture& shown = map.shown;
    const auto [known, isNew] = textures_.try_emplace(
        fmt::format("{}\n{} {} {} {} {} {} {} {} {}", file->path, shown.scale.x, shown.scale.y,
                    shown.offset.x, shown.offset.y, shown.base, shown.gain, shown.exponent,
                    nameOf(shown.wrapU), nameOf(shown.channel)),
        static_cast<int>(file_.textures.size()));
    if (isNew) {
        Texture texture = shown;
        texture.name = map.file;
        texture.image.source = FileSource{file->path};
        file_.textures.push_back(std::move(texture));
    }
    return known->second;
}

void MaterialResolver::scaleBumps() {
    std::vector<ImageWidth> widths(file_.materials.size());
    for (const MeshPart& part : file_.parts) {
        const auto material = static_cast<size_t>(part.material);
        if (file_.materials[material].bump.texture >= 0) { widths[material].add(*part.mesh); }
    }
    for (size_t i = 0; i < widths.size(); ++i) {
        Material& material = file_.materials[i];
        if (material.bump.texture < 0) { continue; }
        material.bumpHeight *=
            widths[i].bumpHeight(file_.textures[static_cast<size_t>(material.bump.texture)]);
    }
}

void MaterialResolver::finish() {
    for (const MtlLibrary& library : libraries_) {
        remarks_.add(library.file.remarks);
    }
    const std::vector<std::string> lines = remarks_.lines();
    file_.warnings.insert(file_.warnings.end(), lines.begin(), lines.end());
    if (!glass_.empty()) {
        file_.notes.push_back(fmt::format("{}: read as glass: {}", objPath_, listed(glass_)));
    }
    if (!opaque_.empty()) {
        file_.notes.push_back(
            fmt::format("{}: read as opaque, though this could mean glass: {}", objPath_, listed(opaque_)));
    }
}

}  // namespace glint

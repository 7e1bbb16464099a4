#include "viewer/model/object_edits.h"

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "engine/scene/generated_mesh.h"
#include "engine/scene/object_box.h"
#include "engine/scene/scene_building.h"
#include "engine/scene/scene_diff.h"
#include "engine/scene/scene_use.h"
#include "engine/scene/shape_forms.h"
#include "viewer/model/camera_controller.h"
#include "viewer/model/copy_name.h"

namespace glint {
namespace {

constexpr float kSizeShare = 0.1f;  // half the size of something new, of the target's distance
const MeshGenerator kBox{"cube", 12, 0};

std::vector<Object>& objectsOf(SceneDocument* document) { return document->draft().objects; }

bool hasSelection(const SceneDocument& document) {
    return document.selectedObject >= 0 &&
           static_cast<size_t>(document.selectedObject) < document.draft().objects.size();
}

std::string nameOf(const Object& object, int index) {
    return object.name.empty() ? "object " + std::to_string(index + 1) : object.name;
}

/// The mesh of a box, which all boxes share.
int boxMesh(SceneDescription* scene) {
    for (size_t i = 0; i < scene->meshes.size(); ++i) {
        const auto* generator = std::get_if<MeshGenerator>(&scene->meshes[i].source);
        if (generator != nullptr && *generator == kBox) { return static_cast<int>(i); }
    }
    scene->meshes.push_back({"box", kBox, *generateMesh(kBox)});
    return static_cast<int>(scene->meshes.size()) - 1;
}

float sizeOfNew(const SceneDocument& document) {
    return kSizeShare * targetDistance(document.draft().camera);
}

void addObject(SceneDocument* document, Object object, std::string_view name) {
    SceneDescription& scene = document->draft();
    if (scene.materials.empty()) { scene.materials.push_back(diffuseMaterial(0.5f)); }
    object.name = name;
    const int last = static_cast<int>(scene.materials.size()) - 1;
    object.material = std::clamp(document->selectedMaterial, 0, last);
    object.objectToWorld =
        translate(scene.camera.target) * scale(Vec3(sizeOfNew(*document))) * object.objectToWorld;
    scene.objects.push_back(object);
    document->selectedObject = static_cast<int>(scene.objects.size()) - 1;
    document->nameEdit("Add " + object.name);
}

/// An object less: what counts objects follows.
void removeAt(SceneDocument* document, int index) {
    objectsOf(document).erase(objectsOf(document).begin() + index);
    document->selectedObject = -1;
    int& focused = document->focusObject;
    if (focused == index) { focused = -1; }
    if (focused > index) { --focused; }
}

bool shines(const SceneDescription& scene, const Object& object) {
    const auto index = static_cast<size_t>(object.material);
    return index < scene.materials.size() && maxComponent(scene.materials[index].emission.value) > 0.0f;
}

}  // namespace

std::vector<ShapeKind> addableShapes() {
    std::vector<ShapeKind> shapes;
    for (const ShapeForm& form : shapeForms()) {
        if (form.transform != nullptr) { shapes.push_back(form.kind); }
    }
    return shapes;
}

void addShape(SceneDocument* document, ShapeKind kind) {
    const ShapeForm& form = shapeForm(kind);
    Object object;
    object.shape = kind;
    // What has a direction lies on the ground.
    const bool isDirected = std::ranges::any_of(
        form.keys(), [](const PlacementKey& key) { return key.form == PlacementForm::Direction; });
    if (isDirected) { object.objectToWorld = rotate({1, 0, 0}, -0.5f * kPi); }
    addObject(document, std::move(object), form.name);
}

void addBox(SceneDocument* document) {
    Object object;
    object.shape = ShapeKind::Mesh;
    object.mesh = boxMesh(&document->draft());
    addObject(document, std::move(object), "box");
}

void addLight(SceneDocument* document) {
    const float size = sizeOfNew(*document);
    Light light;
    light.position = document->draft().camera.target + Vec3(0.0f, 2.0f * size, 0.0f);
    light.color = Vec3(16.0f * size * size);
    document->draft().lights.push_back(light);
    document->selectedLight = static_cast<int>(document->draft().lights.size()) - 1;
    document->selectedObject = -1;  // the handles are the light's
    document->nameEdit("Light added");
}

void duplicateSelection(SceneDocument* document) {
    if (!hasSelection(*document)) { return; }
    const int index = document->selectedObject;
    Object copy = objectsOf(document)[static_cast<size_t>(index)];
    document->nameEdit("Duplicate " + nameOf(copy, index));
    std::vector<std::string_view> taken;
    for (const auto* objects : {&objectsOf(document), &document->draft().hiddenObjects}) {
        for (const Object& object : *objects) {
            taken.push_back(object.name);
        }
    }
    copy.name = copyName(nameOf(copy, index), taken);
    // Beside the original, by its own width.
    copy.objectToWorld.translation += Vec3(2.0f * rowLengths(copy.objectToWorld.linear).x, 0.0f, 0.0f);
    objectsOf(document).push_back(std::move(copy));
    document->selectedObject = static_cast<int>(objectsOf(document).size()) - 1;
}

void deleteSelection(SceneDocument* document) {
    if (!hasSelection(*document)) { return; }
    const int index = document->selectedObject;
    document->nameEdit("Delete " + nameOf(objectsOf(document)[static_cast<size_t>(index)], index));
    removeAt(document, index);
}

void hideSelection(SceneDocument* document) {
    if (!hasSelection(*document)) { return; }
    const int index = document->selectedObject;
    const Object& object = objectsOf(document)[static_cast<size_t>(index)];
    document->nameEdit("Hide " + nameOf(object, index));
    document->draft().hiddenObjects.push_back(object);
    removeAt(document, index);
}

void soloSelection(SceneDocument* document) {
    if (!hasSelection(*document)) { return; }
    const int selected = document->selectedObject;
    std::vector<Object> kept;
    int index = 0;
    int selectedThen = -1;
    for (Object& object : objectsOf(document)) {
        const bool isSelected = index++ == selected;
        if (isSelected) {
            selectedThen = static_cast<int>(kept.size());
            document->nameEdit("Solo " + nameOf(object, selected));
        }
        const bool stays = isSelected || shines(document->draft(), object);
        (stays ? kept : document->draft().hiddenObjects).push_back(std::move(object));
    }
    objectsOf(document) = std::move(kept);
    document->focusObject = document->focusObject == selected ? selectedThen : -1;
    document->selectedObject = selectedThen;
}

void showAll(SceneDocument* document) {
    std::vector<Object>& hidden = document->draft().hiddenObjects;
    std::ranges::move(hidden, std::back_inserter(objectsOf(document)));
    hidden.clear();
    document->nameEdit("Show all");
}

void showHidden(SceneDocument* document, size_t index) {
    std::vector<Object>& hidden = document->draft().hiddenObjects;
    if (index >= hidden.size()) { return; }
    document->nameEdit("Show " + nameOf(hidden[index], static_cast<int>(index)));
    objectsOf(document).push_back(std::move(hidden[index]));
    hidden.erase(hidden.begin() + static_cast<std::ptrdiff_t>(index));
    document->selectedObject = static_cast<int>(objectsOf(document).size()) - 1;
}

namespace {

bool sameButName(const Material& a, const Material& b) {
    SceneDescription sceneA, sceneB;
    sceneA.materials = {a};
    sceneB.materials = {b};
    return listDifferences(sceneA, sceneB).empty();
}

/// The preset among the scene's materials. One of its name that is something else by now stays as it is.
int placeOfPreset(const MaterialPreset& preset, std::vector<Material>* materials) {
    const auto called = [&](const std::string& name) {
        return std::ranges::find(*materials, name, &Material::name);
    };
    std::string name = preset.name;
    for (int number = 2; called(name) != materials->end(); ++number) {
        const auto known = called(name);
        if (sameButName(*known, preset.material)) { return static_cast<int>(known - materials->begin()); }
        name = fmt::format("{} {}", preset.name, number);
    }
    materials->push_back(preset.material);
    materials->back().name = name;
    return static_cast<int>(materials->size()) - 1;
}

}  // namespace

void giveMaterial(SceneDocument* document, int object, const MaterialDrag& given) {
    SceneDescription& scene = document->draft();
    std::vector<Material>& materials = scene.materials;
    int material = given.material;
    if (object < 0 || static_cast<size_t>(object) >= scene.objects.size()) { return; }
    if (given.preset != nullptr) { material = placeOfPreset(*given.preset, &materials); }
    if (material < 0 || static_cast<size_t>(material) >= materials.size()) { return; }
    Object& taker = scene.objects[static_cast<size_t>(object)];
    taker.material = material;
    document->selectedObject = object;
    document->selectedMaterial = material;
    const std::string& name = materials[static_cast<size_t>(material)].name;
    document->nameEdit(nameOf(taker, object) + ": " + (name.empty() ? "another material" : name));
}

namespace {

/// Files beside the other scene, from wherever this one is.
template <class Source>
void makeAbsolute(const std::string& scenePath, Source* source) {
    auto* file = std::get_if<FileSource>(source);
    if (file == nullptr) { return; }
    const auto folder = std::filesystem::absolute(scenePath).parent_path();
    file->path = (folder / file->path).lexically_normal().string();
}

}  // namespace

size_t addScene(const SceneDescription& other, const Vec3& place, float size, SceneDescription* scene) {
    const Bounds bounds = sceneBounds(other);
    const auto textures = static_cast<int>(scene->textures.size());
    const auto materials = static_cast<int>(scene->materials.size());
    const auto meshes = static_cast<int>(scene->meshes.size());
    const Vec3 extent = bounds.hi - bounds.lo;
    const bool isSized = maxComponent(extent) > 0.0f;
    const float factor = isSized ? size / maxComponent(extent) : 1.0f;
    // Its middle stands over the place, its lowest point on it.
    const Vec3 foot =
        isSized ? Vec3(0.5f * (bounds.lo.x + bounds.hi.x), bounds.lo.y, 0.5f * (bounds.lo.z + bounds.hi.z))
                : Vec3(0.0f);
    const Affine moved = translate(place) * scale(Vec3(factor)) * translate(-foot);
    for (Texture texture : other.textures) {
        makeAbsolute(other.path, &texture.image.source);
        scene->textures.push_back(std::move(texture));
    }
    for (Mesh mesh : other.meshes) {
        makeAbsolute(other.path, &mesh.source);
        scene->meshes.push_back(std::move(mesh));
    }
    for (Material material : other.materials) {
        for (int* texture : inputTextures(&material)) {
            if (*texture >= 0) { *texture += textures; }
        }
        scene->materials.push_back(std::move(material));
    }
    const auto add = [&](const std::vector<Object>& from, std::vector<Object>* to) {
        const size_t before = to->size();
        for (Object object : from) {
            const bool hasEnd = object.shape != ShapeKind::Plane;
            if (!hasEnd) { continue; }
            if (object.mesh >= 0) { object.mesh += meshes; }
            object.material += materials;
            object.objectToWorld = moved * object.objectToWorld;
            to->push_back(std::move(object));
        }
        return to->size() - before;
    };
    add(other.hiddenObjects, &scene->hiddenObjects);
    return add(other.objects, &scene->objects);
}

}  // namespace glint

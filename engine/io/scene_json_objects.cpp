// Glint JSON: meshes and objects.
#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "engine/io/importer.h"
#include "engine/io/mesh_normals.h"
#include "engine/io/scene_json_fields.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

bool hasMember(const JsonErrors& errors, const JsonValue& object, std::string_view wanted) {
    bool found = false;
    forEachMember(errors, object, [&](const std::string& key, const JsonValue&) { found |= key == wanted; });
    return found;
}

/// Reads [[…], […], …] of kCount numbers each into `out`.
template <int kCount, class Vector>
void readVectors(JsonErrors& errors, const JsonValue& value, std::string_view what,
                 std::vector<Vector>* out) {
    if (!value.present() || !expectType(errors, value, what, JsonType::Array)) { return; }
    out->reserve(value.size());
    forEachItem(errors, value, [&](const JsonValue& item, size_t) {
        Vector vector;
        if (readNumbers(errors, item, what, kAnyNumber, kCount, &vector[0])) { out->push_back(vector); }
    });
}

void readIndices(JsonErrors& errors, const JsonValue& value, size_t vertexCount, std::vector<uint32_t>* out) {
    if (!value.present() || !expectType(errors, value, "triangles", JsonType::Array)) { return; }
    out->reserve(size_t{3} * value.size());
    const NumberRange range{.lo = 0.0, .hi = static_cast<double>(vertexCount) - 1.0};
    forEachItem(errors, value, [&](const JsonValue& triangle, size_t) {
        if (!triangle.is(JsonType::Array) || triangle.size() != 3) {
            errors.add(triangle,
                       "a triangle needs three vertex numbers: [a, b, c], counter-clockwise from the front");
            return;
        }
        forEachItem(errors, triangle, [&](const JsonValue& corner, size_t) {
            int64_t index = 0;
            if (readInteger(errors, corner, "triangles", range, &index)) {
                out->push_back(static_cast<uint32_t>(index));
            }
        });
    });
}

void checkCount(JsonErrors& errors, const JsonValue& value, std::string_view what, size_t count,
                size_t vertexCount) {
    if (value.present() && count != vertexCount) {
        errors.add(value, fmt::format("\"{}\" has {} entries for {} positions; expected one for each", what,
                                      count, vertexCount));
    }
}

std::vector<std::string_view> objectKeys(const ShapeForm& form) {
    std::vector<std::string_view> keys = fieldKeys<Object>(only(form.kind));
    for (const PlacementKey& key : form.keys()) {
        keys.emplace_back(key.key);
    }
    if (form.kind == ShapeKind::Mesh) { keys.push_back("mesh"); }
    keys.push_back(kHiddenKey);
    return keys;
}

}  // namespace

void SceneJsonReader::readPoints(const JsonValue& value, std::string_view what, std::vector<Vec2>* out) {
    readVectors<2>(errors_, value, what, out);
}

void SceneJsonReader::readPoints(const JsonValue& value, std::string_view what, std::vector<Vec3>* out) {
    readVectors<3>(errors_, value, what, out);
}

void SceneJsonReader::readMeshes(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "meshes", JsonType::Object)) { return; }
    forEachMember(errors_, value, [&](const std::string& name, const JsonValue& mesh) {
        meshNames_[name] = addMesh(mesh, name);
    });
}

int SceneJsonReader::addMesh(const JsonValue& value, const std::string& name) {
    if (errors_.failed() || !expectType(errors_, value, "mesh", JsonType::Object)) { return -1; }
    Mesh mesh;
    mesh.name = name;
    if (hasMember(errors_, value, "positions")) {
        mesh.data = readInlineMesh(value);
    } else if (hasMember(errors_, value, "generator")) {
        MeshGenerator generator;
        readFields(fieldsOf(value, "mesh", fieldKeys<MeshGenerator>()), ~0u, &generator);
        if (Status known = checkMeshGenerator(generator); !known && !errors_.failed()) {
            errors_.add(value, known.error().message);
        }
        mesh.source = generator;
    } else {
        FileSource file;
        readFields(fieldsOf(value, "mesh", fieldKeys<FileSource>()), ~0u, &file);
        mesh.source = file;
    }
    if (errors_.failed()) { return -1; }
    meshPlaces_.push_back(value);
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<int>(scene_.meshes.size()) - 1;
}

std::shared_ptr<const MeshData> SceneJsonReader::readInlineMesh(const JsonValue& value) {
    const JsonFields fields = fieldsOf(value, "mesh", formKeys("meshInline"));
    auto mesh = std::make_shared<MeshData>();
    readVectors<3>(errors_, fields.find("positions"), "positions", &mesh->positions);
    readVectors<3>(errors_, fields.find("normals"), "normals", &mesh->normals);
    readVectors<2>(errors_, fields.find("uvs"), "uvs", &mesh->uvs);
    readVectors<3>(errors_, fields.find("colors"), "colors", &mesh->colors);
    readVectors<4>(errors_, fields.find("tangents"), "tangents", &mesh->tangents);
    const size_t vertexCount = mesh->positions.size();
    checkCount(errors_, fields.find("normals"), "normals", mesh->normals.size(), vertexCount);
    checkCount(errors_, fields.find("uvs"), "uvs", mesh->uvs.size(), vertexCount);
    checkCount(errors_, fields.find("colors"), "colors", mesh->colors.size(), vertexCount);
    checkCount(errors_, fields.find("tangents"), "tangents", mesh->tangents.size(), vertexCount);
    readIndices(errors_, fields.require("triangles"), vertexCount, &mesh->indices);
    if (mesh->indices.empty()) { errors_.add(value, "the mesh has no triangles"); }
    if (!errors_.failed() && turnByNormals(mesh.get()) > 0) {
        remark(value,
               "meshes have triangles that are wound against their normals and turned over: normals "
               "decide which side is the front",
               "");
    }
    return mesh;
}

void SceneJsonReader::readObjects(const JsonValue& value) {
    if (!value.present() || !expectType(errors_, value, "objects", JsonType::Array)) { return; }
    forEachItem(errors_, value, [&](const JsonValue& item, size_t number) { readObject(item, number); });
}

void SceneJsonReader::readObject(const JsonValue& value, size_t number) {
    const std::optional<ShapeKind> shape = kindOf<ShapeKind>(value, "object");
    if (!shape) { return; }
    const ShapeForm& form = shapeForm(*shape);
    const JsonFields fields = fieldsOf(value, form.name, objectKeys(form));
    Object object;
    object.name = fmt::format("{} {}", form.name, number + 1);
    object.shape = *shape;
    readFields(fields, only(*shape), &object);
    bool isHidden = false;
    fields.boolean(kHiddenKey, &isHidden);
    if (const std::string problem = *shape == ShapeKind::Revolved ? profileFault(object) : "";
        !problem.empty() && !errors_.failed()) {
        errors_.add(fields.find("profile"), problem);
    }
    const Affine placement = readPlacement(form, fields);
    const JsonValue transform = fields.find("transform");
    const bool isCanonical = placement == Affine();
    const Affine outer = readTransform(transform);
    object.objectToWorld = !transform.present() ? placement : (isCanonical ? outer : outer * placement);
    if (!errors_.failed() && !isInvertible(object.objectToWorld)) {
        errors_.add(transform.present() ? transform : value,
                    "the object is flattened or not finite in some direction; expected a transform that can "
                    "be undone");
    }
    const JsonValue material =
        object.shape == ShapeKind::Mesh ? fields.find("material") : fields.require("material");
    if (material.present() && !errors_.failed()) { object.material = materialIndex(material, object.name); }
    if (errors_.failed()) { return; }
    const auto first = static_cast<std::ptrdiff_t>(scene_.objects.size());
    if (object.shape == ShapeKind::Mesh) {
        readMeshObject(fields, std::move(object));
    } else {
        scene_.objects.push_back(std::move(object));
    }
    if (isHidden) {
        std::move(scene_.objects.begin() + first, scene_.objects.end(),
                  std::back_inserter(scene_.hiddenObjects));
        scene_.objects.erase(scene_.objects.begin() + first, scene_.objects.end());
    }
}

void SceneJsonReader::readMeshObject(const JsonFields& fields, Object object) {
    const JsonValue mesh = fields.require("mesh");
    const bool hasMaterial = fields.find("material").present();
    if (!mesh.present()) { return; }
    std::string file;
    if (!hasMaterial && mesh.is(JsonType::Object)) {
        forEachMember(errors_, mesh, [&](const std::string& key, const JsonValue& member) {
            file = key == "file" && member.is(JsonType::String) ? member.string() : file;
        });
    }
    if (bringsMaterials(file) && mesh.size() == 1) {
        addWholeFile(file, mesh, object);
        return;
    }
    if (!hasMaterial) {
        errors_.add(fields.object(),
                    "mesh has no \"material\", which only whole .obj, .ply and .stl files bring themselves");
        return;
    }
    object.mesh = meshIndex(mesh, object.name);
    if (object.mesh >= 0) { scene_.objects.push_back(std::move(object)); }
}

void SceneJsonReader::addWholeFile(const std::string& path, const JsonValue& at, const Object& prototype) {
    const auto file = assets_.meshFileWithMaterials(path);
    if (!file) {
        reportFile(at, path, file.error());
        return;
    }
    appendMeshFile(**file, path, prototype, &scene_);
    meshPlaces_.resize(scene_.meshes.size(), at);
    for (size_t i = texturePlaces_.size(); i < scene_.textures.size(); ++i) {
        broughtTextures_.insert(i);
    }
    texturePlaces_.resize(scene_.textures.size(), at);
}

int SceneJsonReader::meshIndex(const JsonValue& value, const std::string& ownerName) {
    return value.is(JsonType::Object) ? addMesh(value, "mesh of " + ownerName)
                                      : findName(meshNames_, value, "mesh");
}

}  // namespace glint

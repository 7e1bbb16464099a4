// The reader behind readSceneJson: one method per part of the format, in one file per part. Internal
// to engine/io.
//
// The first error is kept in errors_; methods go on with defaults after it and the root method asks at
// the end.
#pragma once

#include <map>
#include <set>
#include <string>

#include "engine/io/asset_cache.h"
#include "engine/io/embedded_files.h"
#include "engine/io/json_fields.h"
#include "engine/io/load_options.h"
#include "engine/io/used_assets.h"
#include "engine/scene/field.h"
#include "engine/scene/kind_names.h"
#include "engine/scene/shape_forms.h"

namespace glint {

class SceneJsonReader {
  public:
    SceneJsonReader(std::shared_ptr<const JsonDocument> document, const LoadOptions& options);

    Result<SceneDescription> read(const EmbeddedByPath& embedded);

  private:
    // scene_json.cpp: the root and what has no parts.
    void readRoot(const JsonFields& root);
    void readResolution(const JsonValue& value);
    void readCamera(const JsonValue& value);
    void readRender(const JsonValue& value);

    // scene_json_assets.cpp: files, once it is known what uses them.
    void readAssets();
    /// Warns of missing files that nothing uses.
    void checkIdleAssets();
    const JsonValue& placeOf(const Asset& asset) const;
    /// Records a missing or unreadable file: an error at `at`, or a warning where missing files are allowed.
    void reportFile(const JsonValue& at, const std::string& path, const Error& error);
    void remark(const JsonValue& at, std::string_view kind, std::string_view detail);

    // scene_json_materials.cpp
    void readTextures(const JsonValue& value);
    void readMaterials(const JsonValue& value);
    int addTexture(const JsonValue& value, const std::string& name);
    Material readMaterial(const JsonValue& value, const std::string& name);
    /// Either a known "metal", or "eta" and "k".
    void checkMetal(const JsonFields& fields, Material* material);
    /// A known "glass", or "iorRgb", or "ior" and "abbeNumber".
    void checkGlass(const JsonFields& fields);
    void checkName(const JsonValue& value, std::string_view key, const std::vector<std::string_view>& known);
    /// A constant, or a texture with the constant as its fallback.
    void readInput(const JsonFields& fields, std::string_view key, const NumberRange& range,
                   ColorInput* color);
    void readInput(const JsonFields& fields, std::string_view key, const NumberRange& range,
                   NumberInput* number);
    int textureUse(const JsonFields& use);
    int textureIndex(const JsonValue& value);
    /// A material by its name, or described in place.
    int materialIndex(const JsonValue& value, const std::string& ownerName);

    // scene_json_objects.cpp
    void readMeshes(const JsonValue& value);
    void readPoints(const JsonValue& value, std::string_view what, std::vector<Vec2>* out);
    void readPoints(const JsonValue& value, std::string_view what, std::vector<Vec3>* out);
    void readObjects(const JsonValue& value);
    void readObject(const JsonValue& value, size_t number);
    void readMeshObject(const JsonFields& fields, Object object);
    void addWholeFile(const std::string& path, const JsonValue& at, const Object& prototype);
    int meshIndex(const JsonValue& value, const std::string& ownerName);
    int addMesh(const JsonValue& value, const std::string& name);
    std::shared_ptr<const MeshData> readInlineMesh(const JsonValue& value);

    // scene_json_transform.cpp
    Affine readPlacement(const ShapeForm& form, const JsonFields& fields);
    Affine readTransform(const JsonValue& value);
    Affine readTransformStep(const JsonValue& value);

    // scene_json_lights.cpp
    void readLights(const JsonValue& value);
    Light readLight(const JsonValue& value);
    void readEnvironment(const JsonValue& value);
    void readEnvironmentImage(const JsonValue& value);
    SkySource readSky(const JsonValue& value);

    // scene_json_fields.h
    template <class Member>
    void readValue(const JsonFields& fields, std::string_view key, const FieldTraits& traits, Member* out);
    /// Reads all fields that some kinds of the type have, but for custom ones.
    template <class Owner>
    void readFields(const JsonFields& fields, uint32_t kinds, Owner* owner);

    JsonFields fieldsOf(const JsonValue& value, std::string_view what, std::vector<std::string_view> keys) {
        return {errors_, value, what, std::move(keys)};
    }
    /// The index of the object's "type" among `kinds`, or -1 with an error.
    int typeOf(const JsonValue& value, std::string_view what, std::span<const std::string_view> kinds);
    /// The same as a kind; nothing with an error.
    template <class Kind>
    std::optional<Kind> kindOf(const JsonValue& value, std::string_view what) {
        const int index = typeOf(value, what, namesOf<Kind>());
        if (index < 0) { return std::nullopt; }
        return kindNames<Kind>()[static_cast<size_t>(index)].kind;
    }
    int findName(const std::map<std::string, int>& names, const JsonValue& value, std::string_view what);

    std::shared_ptr<const JsonDocument> document_;
    LoadOptions options_;
    JsonErrors errors_;
    AssetCache assets_;
    SceneDescription scene_;
    std::map<std::string, int> textureNames_;
    std::map<std::string, int> materialNames_;
    std::map<std::string, int> meshNames_;
    std::vector<JsonValue> texturePlaces_;  ///< where each texture and mesh of the scene names its file
    std::vector<JsonValue> meshPlaces_;
    std::set<size_t> broughtTextures_;  ///< those that mesh files' materials name
    JsonValue environmentPlace_;
    Remarks remarks_;
};

/// Calls body(value, number) for each element of an array until there is an error.
template <class Body>
void forEachItem(const JsonErrors& errors, const JsonValue& array, Body body) {
    size_t number = 0;
    for (JsonValue item = array.first(); item.present() && !errors.failed(); item = array.next(item)) {
        body(item, number++);
    }
}

/// Calls body(key, value) for each member of an object until there is an error.
template <class Body>
void forEachMember(const JsonErrors& errors, const JsonValue& object, Body body) {
    JsonValue key = object.first();
    while (key.present() && !errors.failed()) {
        const JsonValue value = object.next(key);
        body(key.string(), value);
        key = object.next(value);
    }
}

}  // namespace glint

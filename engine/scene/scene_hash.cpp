// Field by field, since padding has no defined content.
#include "engine/scene/scene_hash.h"

#include <algorithm>
#include <array>

#include "engine/math/color.h"
#include "engine/scene/field_text.h"
#include "engine/scene/scene_fields.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

void add(ContentHash& hash, const Vec2& v) {
    hash.add(v.x);
    hash.add(v.y);
}

void add(ContentHash& hash, const Vec3& v) {
    hash.add(v.x);
    hash.add(v.y);
    hash.add(v.z);
}

/// Arrays of numbers and of vectors, which hold no padding.
template <class T>
void add(ContentHash& hash, const std::vector<T>& values) {
    hash.addBytes(values.data(), values.size() * sizeof(T));
}

void add(ContentHash& hash, const Affine& transform) {
    for (int column = 0; column < 3; ++column) {
        add(hash, transform.linear[column]);
    }
    add(hash, transform.translation);
}

void add(ContentHash& hash, const SceneImage& image) {
    if (image.bytes) {
        hash.add(image.bytes->width);
        hash.add(image.bytes->height);
        add(hash, image.bytes->rgb);
        add(hash, image.bytes->alpha);
    }
    if (image.floats) {
        hash.add(image.floats->width);
        hash.add(image.floats->height);
        add(hash, image.floats->rgb);
    }
}

/// As linear floats, which an 8-bit one was made in earlier versions.
void addEnvironment(ContentHash& hash, const SceneImage& image) {
    if (!image.bytes) { return add(hash, image); }
    const std::vector<uint8_t>& rgb = image.bytes->rgb;
    hash.add(image.bytes->width);
    hash.add(image.bytes->height);
    hash.beginBytes(rgb.size() * sizeof(float));
    std::array<float, 4096> piece;
    for (size_t done = 0; done < rgb.size(); done += piece.size()) {
        const size_t count = std::min(piece.size(), rgb.size() - done);
        for (size_t i = 0; i < count; ++i) {
            piece[i] = srgbToLinear(static_cast<float>(rgb[done + i]) / 255.0f);
        }
        hash.addPiece(piece.data(), count * sizeof(float));
    }
}

template <class T>
requires requires(ContentHash hash, const T& value) { hash.add(value); }
void add(ContentHash& hash, const T& value) { hash.add(value); }

/// A constant adds no more than it did before inputs other than the colour could be textured.
template <class Input>
void addInput(ContentHash& hash, std::string_view key, const Input& input) {
    add(hash, input.value);
    if (key == "color") {
        hash.add(input.texture);
    } else if (input.texture >= 0) {
        hash.add(key);
        hash.add(input.texture);
    }
}

template <class Owner>
requires HasFields<Owner>
void add(ContentHash& hash, const Owner& owner) {
    forEachField<Owner>([&]<class Member>(const Field<Owner, Member>& field) {
        if (!field.traits.inFingerprint || field.traits.alias) { return; }
        if (field.traits.onlyOwnKinds && (field.traits.kinds & kindBit(owner)) == 0) { return; }
        if constexpr (std::equality_comparable<Member>) {
            if (field.traits.onlyIfSet) {
                if (owner.*field.member == Owner{}.*field.member) { return; }
                hash.add(field.key);
            }
        }
        if (field.traits.inFingerprintIfSaved && !field.hooks.isSaved(owner)) { return; }
        if constexpr (kIsInput<Member>) {
            addInput(hash, field.key, owner.*field.member);
        } else {
            add(hash, owner.*field.member);
        }
    });
}

void add(ContentHash& hash, const MeshData& mesh, bool isTextured) {
    add(hash, mesh.positions);
    add(hash, mesh.normals);
    if (isTextured) { add(hash, mesh.uvs); }
    add(hash, mesh.colors);
    if (!mesh.tangents.empty()) { add(hash, mesh.tangents); }
    add(hash, mesh.indices);
}

template <class T>
void addAll(ContentHash& hash, const std::vector<T>& items) {
    hash.add(static_cast<uint64_t>(items.size()));
    for (const T& item : items) {
        add(hash, item);
    }
}

void addGeometry(ContentHash& hash, const SceneDescription& scene) {
    addAll(hash, scene.objects);
    const std::vector<bool> used = usedMeshes(scene);
    const std::vector<bool> textured = texturedMeshes(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i] && scene.meshes[i].data) { add(hash, *scene.meshes[i].data, textured[i]); }
    }
}

void addTextures(ContentHash& hash, const SceneDescription& scene) {
    hash.add(static_cast<uint64_t>(scene.textures.size()));
    const std::vector<bool> used = usedTextures(scene);
    for (size_t i = 0; i < used.size(); ++i) {
        if (used[i]) { add(hash, scene.textures[i]); }
    }
}

void addLights(ContentHash& hash, const SceneDescription& scene) {
    addAll(hash, scene.lights);
    add(hash, scene.environment);
    hash.add(static_cast<uint64_t>(scene.environmentImages.size()));
    if (usesEnvironmentImage(scene)) {
        addEnvironment(hash, scene.environmentImages[static_cast<size_t>(scene.environment.image)]);
    }
}

Hash128 hashPart(const SceneDescription& scene, ScenePart part) {
    ContentHash hash;
    switch (part) {
        case ScenePart::Camera:
            add(hash, scene.camera);
            break;
        case ScenePart::Geometry:
            addGeometry(hash, scene);
            break;
        case ScenePart::Materials:
            addAll(hash, scene.materials);
            break;
        case ScenePart::Textures:
            addTextures(hash, scene);
            break;
        case ScenePart::Lights:
            addLights(hash, scene);
            break;
    }
    return hash.finish();
}

template <class Owner>
void addSettings(const Owner& owner, std::vector<Setting>* settings) {
    forEachField<Owner>([&](const auto& field) {
        if (!field.traits.inFingerprint) { return; }
        const std::string_view name = field.traits.setting.empty() ? field.key : field.traits.setting;
        settings->push_back({std::string(name), fieldText(field, owner)});
    });
}

}  // namespace

const char* scenePartName(ScenePart part) {
    switch (part) {
        case ScenePart::Camera:
            return "the camera";
        case ScenePart::Geometry:
            return "the geometry";
        case ScenePart::Materials:
            return "the materials";
        case ScenePart::Textures:
            return "the textures";
        case ScenePart::Lights:
            return "the lights";
    }
    return "";
}

SceneHashes hashSceneParts(const SceneDescription& scene) {
    SceneHashes hashes;
    for (size_t i = 0; i < hashes.parts.size(); ++i) {
        hashes.parts[i] = hashPart(scene, static_cast<ScenePart>(i));
    }
    return hashes;
}

std::vector<Setting> renderSettings(const SceneDescription& scene) {
    std::vector<Setting> settings;
    addSettings(scene.resolution, &settings);
    addSettings(scene.options, &settings);
    forEachIntegratorOptions([&](IntegratorKind kind, auto member) {
        if (scene.options.integrator == kind) { addSettings(scene.*member, &settings); }
    });
    return settings;
}

Hash128 sceneHash(const SceneDescription& scene) {
    ContentHash hash;
    for (const Hash128& part : hashSceneParts(scene).parts) {
        hash.add(part.low);
        hash.add(part.high);
    }
    for (const Setting& setting : renderSettings(scene)) {
        hash.add(setting.name);
        hash.add(setting.value);
    }
    return hash.finish();
}

}  // namespace glint

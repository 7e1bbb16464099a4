#include "engine/render/memory_use.h"

#include <numeric>
#include <set>

#include "engine/builders/instance_builder.h"
#include "engine/builders/light_table.h"
#include "engine/builders/material_table.h"
#include "engine/builders/mesh_builder.h"
#include "engine/builders/tangent_builder.h"
#include "engine/builders/texture_table.h"
#include "engine/render/film.h"
#include "engine/render/integrator.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

constexpr std::array<const char*, kMemoryPartCount> kPartNames{"vertices and indices",
                                                               "normals, texture coordinates, vertex colours",
                                                               "acceleration structures of meshes",
                                                               "instances and top level",
                                                               "materials",
                                                               "textures",
                                                               "lights",
                                                               "environment image and its distribution",
                                                               "film",
                                                               "pass buffer",
                                                               "previews",
                                                               "AOVs and their pass buffer",
                                                               "SPPM: statistics of the pixels",
                                                               "SPPM: visible points",
                                                               "SPPM: photons and their structure, about",
                                                               "SPPM: emission tables"};

template <class Item>
uint64_t bytesOf(const std::vector<Item>& items) {
    return items.size() * sizeof(Item);
}

bool readsTextureCoordinates(FeatureMask features) { return (features & kFeatureTextures) != 0; }

void addVertices(const MeshData& mesh, bool withTextureCoordinates, MemoryUse* use) {
    (*use)[MemoryPart::Vertices] += bytesOf(mesh.positions) + bytesOf(mesh.indices);
    (*use)[MemoryPart::VertexShading] += bytesOf(mesh.normals) + bytesOf(mesh.colors) +
                                         bytesOf(mesh.tangents) +
                                         (withTextureCoordinates ? bytesOf(mesh.uvs) : 0);
}

}  // namespace

uint64_t MemoryUse::total() const { return std::accumulate(bytes.begin(), bytes.end(), uint64_t{0}); }

void MemoryUse::add(const MemoryUse& other) {
    for (size_t i = 0; i < bytes.size(); ++i) {
        bytes[i] += other.bytes[i];
    }
}

const char* memoryPartName(MemoryPart part) { return kPartNames[static_cast<size_t>(part)]; }

MemoryUse memoryOf(const BuiltScene& scene) {
    MemoryUse use;
    std::set<const MeshData*> vertices;
    std::set<const BuiltMesh*> meshes;
    for (const auto& mesh : scene.meshes) {
        if (mesh && meshes.insert(mesh.get()).second) {
            use[MemoryPart::MeshStructures] += mesh->accelerationBytes();
            if (mesh->isReady && vertices.insert(mesh->data.get()).second) {
                addVertices(*mesh->data, readsTextureCoordinates(scene.features), &use);
            }
        }
    }
    std::set<const MeshTangents*> tangents;
    for (const auto& mesh : scene.tangents) {
        if (mesh && tangents.insert(mesh.get()).second) {
            use[MemoryPart::VertexShading] += bytesOf(mesh->alongU);
        }
    }
    use[MemoryPart::Instances] = scene.instances ? scene.instances->bytes() : 0;
    use[MemoryPart::Materials] = scene.materials ? scene.materials->bytes() : 0;
    use[MemoryPart::Textures] = scene.textures ? scene.textures->bytes() : 0;
    if (scene.lights) {
        use[MemoryPart::Environment] = scene.lights->environment ? scene.lights->environment->bytes() : 0;
        use[MemoryPart::Lights] = scene.lights->bytes() - use[MemoryPart::Environment];
    }
    return use;
}

MemoryUse plannedMemory(const SceneDescription& scene, IntegratorKind integrator, bool aovs) {
    const int width = scene.resolution.width, height = scene.resolution.height;
    const uint64_t pixels = static_cast<uint64_t>(width) * static_cast<uint64_t>(height);
    MemoryUse use;
    use[MemoryPart::Film] = Film::bytesFor(width, height);
    use[MemoryPart::PassSamples] = pixels * sizeof(PixelSample);
    if (aovs) { use[MemoryPart::Aovs] = AovFilm::bytesFor(width, height) + pixels * sizeof(AovSample); }
    integratorType(integrator).addPlannedMemory(scene, &use);
    return use;
}

MemoryUse unusedMemory(const SceneDescription& scene, FeatureMask features) {
    MemoryUse use;
    const std::vector<bool> usedMesh = usedMeshes(scene);
    std::set<const MeshData*> meshes;
    for (size_t i = 0; i < scene.meshes.size(); ++i) {
        if (usedMesh[i] && meshes.insert(scene.meshes[i].data.get()).second) {
            use[MemoryPart::VertexShading] +=
                readsTextureCoordinates(features) ? 0 : bytesOf(scene.meshes[i].data->uvs);
        }
    }
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.data && meshes.insert(mesh.data.get()).second) { addVertices(*mesh.data, true, &use); }
    }
    const std::vector<bool> usedTexture = usedTextures(scene);
    std::vector<SceneImage> all, used;
    for (size_t i = 0; i < scene.textures.size(); ++i) {
        all.push_back(scene.textures[i].image);
        if (usedTexture[i]) { used.push_back(scene.textures[i].image); }
    }
    use[MemoryPart::Textures] = imageBytes(all) - imageBytes(used);
    const auto chosen = static_cast<size_t>(scene.environment.image);
    use[MemoryPart::Environment] =
        imageBytes(scene.environmentImages) -
        (usesEnvironmentImage(scene) ? imageBytes({scene.environmentImages[chosen]}) : 0);
    return use;
}

uint64_t leftOutUvBytes(const SceneDescription& scene) {
    uint64_t sum = 0;
    std::set<const MeshData*> meshes;
    for (const Mesh& mesh : scene.meshes) {
        if (mesh.data && mesh.data->uvsLeftOut && meshes.insert(mesh.data.get()).second) {
            sum += mesh.data->positions.size() * sizeof(Vec2);
        }
    }
    return sum;
}

}  // namespace glint

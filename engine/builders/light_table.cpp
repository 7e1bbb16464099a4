#include "engine/builders/light_table.h"

#include <algorithm>
#include <cmath>

#include "engine/base/parallel.h"
#include "engine/builders/emission_means.h"
#include "engine/builders/light_tree_builder.h"
#include "engine/builders/point_emitters.h"
#include "engine/builders/repeated_triangles.h"
#include "engine/kernels/shapes/shape_facts.h"
#include "engine/math/color.h"
#include "engine/scene/profile.h"

namespace glint {
namespace {

class TableBuilder {
  public:
    TableBuilder(const SceneDescription& scene, const TextureTable& textures, int threads)
        : scene_(scene), textures_(textures), threads_(threads) {}

    std::shared_ptr<LightTable> build() {
        table_->firstEmitter.assign(scene_.objects.size(), kNone);
        for (size_t i = 0; i < scene_.objects.size(); ++i) {
            addObject(i);
        }
        addLights(false);
        table_->finiteCount = static_cast<uint32_t>(table_->emitters.size());
        addLights(true);
        return table_;
    }

  private:
    void addObject(size_t index) {
        const Object& object = scene_.objects[index];
        const Material& material = scene_.materials[static_cast<size_t>(object.material)];
        if (!material.emissive() || !isSampledAsLight(object.shape)) { return; }
        if (object.shape == ShapeKind::Mesh && !scene_.meshes[static_cast<size_t>(object.mesh)].data) {
            return;
        }
        const size_t first = table_->emitters.size();
        table_->firstEmitter[index] = static_cast<uint32_t>(first);
        if (object.shape == ShapeKind::Mesh) {
            addMesh(object, *scene_.meshes[static_cast<size_t>(object.mesh)].data, material.emitsBothSides);
        } else if (object.shape == ShapeKind::Revolved) {
            table_->emitters.push_back(
                RevolvedShape::makeEmitter(object.objectToWorld, profileBounds(object.profile)));
        } else {
            table_->emitters.push_back(visitShape<EmitterData, kAnalyticOnly<kAllFeatures>>(
                object.shape,
                [&](auto shape) { return decltype(shape)::makeEmitter(object.objectToWorld); }));
        }
        for (size_t i = first; i < table_->emitters.size(); ++i) {
            table_->emitters[i].shape = object.shape;
            table_->emitters[i].radiance = material.emission.value * material.emissionStrength;
            table_->emitters[i].emitsBothSides = material.emitsBothSides && !object.frontOnly;
            table_->emitters[i].instance = static_cast<uint32_t>(index);
        }
        const uint32_t texture = textures_.packed(material.emission.texture);
        if (texture != kNone) {
            setMeans(object, textures_.textures[texture], material.emissionStrength, first);
        }
    }

    /// The radiance of one object's emitters by its emission texture.
    void setMeans(const Object& object, const TextureView& texture, float strength, size_t first) {
        const EmissionMeans means(texture);
        if (object.shape != ShapeKind::Mesh) {
            table_->emitters[first].radiance = means.overAll() * strength;
            return;
        }
        const MeshData& mesh = *scene_.meshes[static_cast<size_t>(object.mesh)].data;
        const auto uvOf = [&](size_t corner) {
            constexpr Vec2 kOfWeights[] = {Vec2(0.0f), Vec2(1.0f, 0.0f), Vec2(0.0f, 1.0f)};
            return mesh.uvs.empty() ? kOfWeights[corner % 3] : mesh.uvs[mesh.indices[corner]];
        };
        parallelChunks(mesh.triangleCount(), 1 << 12, threads_, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                const size_t corner = 3 * static_cast<size_t>(i);
                table_->emitters[first + static_cast<size_t>(i)].radiance =
                    means.overTriangle(uvOf(corner), uvOf(corner + 1), uvOf(corner + 2)) * strength;
            }
        });
    }

    void addMesh(const Object& object, const MeshData& mesh, bool bothSides) {
        const size_t first = table_->emitters.size();
        const bool mirrored = glm::determinant(glm::dmat3(object.objectToWorld.linear)) < 0.0;
        const std::vector<uint32_t> original = firstOfRepeatedTriangles(mesh, bothSides);
        table_->emitters.resize(first + mesh.triangleCount());
        parallelChunks(mesh.triangleCount(), 1 << 14, threads_, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                EmitterData& e = table_->emitters[first + static_cast<size_t>(i)];
                e = MeshShape::makeEmitter(object.objectToWorld, mesh.positions.data(),
                                           mesh.indices.data() + 3 * i, mirrored);
                e.original = static_cast<uint32_t>(first) + original[static_cast<size_t>(i)];
                if (original[static_cast<size_t>(i)] != i) { e.area = 0.0f; }
            }
        });
    }

    void addLights(bool directional) {
        for (const Light& light : scene_.lights) {
            if ((light.kind == LightKind::Directional) != directional) { continue; }
            const EmitterData e = pointlikeEmitter(light, textures_);
            if (!(maxComponent(e.radiance) > 0.0f)) { continue; }
            table_->castLights.push_back(e);
            if (!light.onlyRayCast) { table_->emitters.push_back(e); }
        }
    }

    const SceneDescription& scene_;
    const TextureTable& textures_;
    const int threads_;
    std::shared_ptr<LightTable> table_ = std::make_shared<LightTable>();
};

/// The portal; says which even luminance would have as much of a white environment's light fall on it.
float addPortal(const SceneDescription& scene, const LightTable* previous, int threads, LightTable* table) {
    table->portal = portalOpening(scene.environment);
    if (!table->environment) { return 1.0f; }
    table->portalSums =
        buildPortalSums(table->environment->source, table->view().environment, table->environmentRotationRad,
                        table->portal, previous != nullptr ? previous->portalSums : nullptr, threads);
    return table->portalSums->irradiance * kInvPi;
}

void addEnvironment(const SceneDescription& scene, const LightTable* previous, int threads,
                    LightTable* table) {
    const Environment& environment = scene.environment;
    if (!environment.emissive()) { return; }
    table->environmentRadiance = environment.color * environment.strength;
    float mean = 1.0f;
    if (environment.image >= 0) {
        const SceneImage& source = scene.environmentImages[static_cast<size_t>(environment.image)];
        const bool same = previous != nullptr && previous->environment != nullptr &&
                          previous->environment->source.bytes == source.bytes &&
                          previous->environment->source.floats == source.floats;
        table->environment = same ? previous->environment : buildEnvironmentTable(source, threads);
        table->environmentRotationRad = environment.rotationDeg * (kPi / 180.0f);
        if (table->environment) { mean = table->environment->meanLuminance; }
    }
    if (!environment.portal.empty()) { mean = addPortal(scene, previous, threads, table); }
    table->environmentIsSeenOnly = environment.seenOnly;
    if (environment.seenOnly) { return; }
    table->environmentIrradiance = luminance(table->environmentRadiance) * mean * kPi;
    if (!(table->environmentIrradiance > 0.0f)) { return; }
    EmitterData e;
    e.kind = EmitterKind::Environment;
    table->emitters.push_back(e);
}

/// What lights are chosen by: that of `previous`, which may be null, where it has the same ones.
void addSelection(const LightTable* previous, LightTable* table) {
    if (previous != nullptr && previous->finiteCount == table->finiteCount &&
        previous->emitters == table->emitters) {
        table->nodes = previous->nodes;
        table->emitterNodes = previous->emitterNodes;
        table->usesTree = previous->usesTree;
        return;
    }
    table->nodes.resize(table->finiteCount);
    for (uint32_t i = 0; i < table->finiteCount; ++i) {
        table->nodes[i] = leafNode(table->emitters[i]);
        table->nodes[i].child = i;
    }
    table->usesTree = table->finiteCount > kFewLights;
    if (!table->usesTree) { return; }
    LightTree tree = buildLightTree(table->nodes);
    table->nodes = std::move(tree.nodes);
    table->emitterNodes = std::move(tree.emitterNodes);
}

}  // namespace

FeatureMask LightTable::features() const {
    FeatureMask mask = usesTree ? kFeatureManyLights : FeatureMask{0};
    if (std::any_of(firstEmitter.begin(), firstEmitter.end(), [](uint32_t e) { return e != kNone; })) {
        mask |= kFeatureAreaLights;
    }
    for (const EmitterData& e : emitters) {
        if (isDeltaLight(e.kind)) { mask |= kFeatureDeltaLights; }
    }
    for (const EmitterData& e : castLights) {
        if (e.kind == EmitterKind::Projector || e.kind == EmitterKind::Goniometric) {
            mask |= kFeatureProjectors;
        }
    }
    if (maxComponent(environmentRadiance) > 0.0f) {
        mask |= environment ? kFeatureEnvironmentImage : kFeatureEnvironmentConstant;
        if (portal.area > 0.0f) { mask |= kFeaturePortal; }
    }
    return mask;
}

LightView LightTable::view() const {
    LightView v;
    v.emitters = viewOf(emitters);
    v.nodes = viewOf(nodes);
    v.emitterNodes = viewOf(emitterNodes);
    v.finiteCount = finiteCount;
    v.usesTree = usesTree;
    v.environmentIsSeenOnly = environmentIsSeenOnly;
    v.castLights = viewOf(castLights);
    v.environmentIrradiance = environmentIrradiance;
    v.environmentRadiance = environmentRadiance;
    if (environment) {
        v.environment = environment->view();
        v.environment.cosRotation = std::cos(environmentRotationRad);
        v.environment.sinRotation = std::sin(environmentRotationRad);
    }
    v.portal.opening = portal;
    if (portalSums) {
        v.portal.sums = portalSums->sums.data();
        v.portal.size = portalSums->size;
    }
    return v;
}

size_t LightTable::bytes() const {
    return (emitters.size() + castLights.size()) * sizeof(EmitterData) + nodes.size() * sizeof(LightNode) +
           (emitterNodes.size() + firstEmitter.size()) * sizeof(uint32_t) +
           (environment ? environment->bytes() : 0) + (portalSums ? portalSums->bytes() : 0);
}

std::shared_ptr<const LightTable> buildLightTable(const SceneDescription& scene, const TextureTable& textures,
                                                  const std::shared_ptr<const LightTable>& previous,
                                                  int threads) {
    std::shared_ptr<LightTable> table = TableBuilder(scene, textures, threads).build();
    addEnvironment(scene, previous.get(), threads, table.get());
    addSelection(previous.get(), table.get());
    if (previous && *previous == *table) { return previous; }
    return table;
}

}  // namespace glint

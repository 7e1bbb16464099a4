#include "engine/builders/light_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/base/parallel.h"
#include "engine/builders/light_tree_builder.h"
#include "engine/builders/repeated_triangles.h"
#include "engine/kernels/geometry_view.h"
#include "engine/math/color.h"

namespace glint {
namespace {

Vec3 emittedRadiance(const Material& material) { return material.emission.value * material.emissionStrength; }

/// The transform keeps angles: a sphere stays a sphere.
bool isSimilarity(const Mat3& m) {
    constexpr double kTolerance = 1e-5;
    const glm::dvec3 x(m[0]), y(m[1]), z(m[2]);
    const double size = glm::dot(x, x);
    return std::abs(glm::dot(y, y) - size) <= kTolerance * size &&
           std::abs(glm::dot(z, z) - size) <= kTolerance * size &&
           std::abs(glm::dot(x, y)) <= kTolerance * size && std::abs(glm::dot(y, z)) <= kTolerance * size &&
           std::abs(glm::dot(z, x)) <= kTolerance * size;
}

/// The unit normal in world space of an object's +z side.
Vec3 worldNormal(const Affine& objectToWorld, const Vec3& normalObject) {
    const glm::dmat3 inverseTranspose = glm::transpose(glm::inverse(glm::dmat3(objectToWorld.linear)));
    return Vec3(glm::normalize(inverseTranspose * glm::dvec3(normalObject)));
}

/// Twice the area of the triangle (or the area of the parallelogram) that two edges span.
float crossLength(const Vec3& a, const Vec3& b) {
    return static_cast<float>(glm::length(glm::cross(glm::dvec3(a), glm::dvec3(b))));
}

EmitterData sphereEmitter(const Affine& m) {
    EmitterData e;
    e.tag = isSimilarity(m.linear) ? EmitterTag::Sphere : EmitterTag::Ellipsoid;
    e.position = m.translation;
    // An ellipsoid only needs a bound: the Frobenius norm is never below the largest half axis.
    const float squares =
        lengthSquared(m.linear[0]) + lengthSquared(m.linear[1]) + lengthSquared(m.linear[2]);
    e.radiusWorld = std::sqrt(e.tag == EmitterTag::Sphere ? squares / 3.0f : squares);
    return e;
}

EmitterData flatEmitter(const Affine& m, ShapeKind shape) {
    EmitterData e;
    e.position = m.translation;
    e.axisU = m.linear[0];
    e.axisV = m.linear[1];
    e.direction = worldNormal(m, {0, 0, 1});
    const float span = crossLength(e.axisU, e.axisV);
    if (shape == ShapeKind::Disc) {
        e.tag = EmitterTag::Disc;
        e.area = kPi * span;
    } else {
        const float skew = absDot(e.axisU, e.axisV) / (glm::length(e.axisU) * glm::length(e.axisV));
        e.tag = skew < 1e-5f ? EmitterTag::Rectangle : EmitterTag::Parallelogram;
        e.area = 4.0f * span;
    }
    return e;
}

EmitterData triangleEmitter(const Affine& m, const MeshData& mesh, uint32_t triangle, bool mirrored) {
    const uint32_t* index = mesh.indices.data() + 3 * static_cast<size_t>(triangle);
    const Vec3 v0 = m.point(mesh.positions[index[0]]);
    EmitterData e;
    e.tag = EmitterTag::Triangle;
    e.position = v0;
    e.axisU = m.point(mesh.positions[index[1]]) - v0;
    e.axisV = m.point(mesh.positions[index[2]]) - v0;
    e.area = 0.5f * crossLength(e.axisU, e.axisV);
    const glm::dvec3 n = glm::cross(glm::dvec3(e.axisU), glm::dvec3(e.axisV));
    const double length = glm::length(n);
    // Under mirroring the edges turn the other way round while the front stays the front.
    if (length > 0.0) { e.direction = Vec3((mirrored ? -n : n) / length); }
    if (!(length > 0.0)) { e.area = 0.0f; }
    return e;
}

/// 1 - cos as 2 sin^2 of the half: keeps its digits for narrow angles.
float oneMinusCosine(float angleDeg) {
    const double sine = std::sin(static_cast<double>(angleDeg) * (std::numbers::pi / 360.0));
    return static_cast<float>(2.0 * sine * sine);
}

EmitterData pointlikeEmitter(const Light& light) {
    EmitterData e;
    e.position = light.position;
    e.radiance = light.color * light.strength;
    const float length = glm::length(light.direction);
    e.direction = length > 0.0f ? light.direction / length : Vec3(0, -1, 0);
    switch (light.kind) {
        case LightKind::Point:
            e.tag = EmitterTag::Point;
            break;
        case LightKind::Spot:
            e.tag = EmitterTag::Spot;
            break;
        case LightKind::Directional:
            e.tag = EmitterTag::Directional;
            break;
    }
    e.oneMinusCosOuter = oneMinusCosine(light.coneAngleDeg);
    e.oneMinusCosInner = oneMinusCosine(std::min(light.coneFalloffStartDeg, light.coneAngleDeg));
    if (e.tag == EmitterTag::Directional) { e.area = luminance(e.radiance); }
    return e;
}

void boundFlat(const EmitterData& e, LightNode* node) {
    node->axis = e.direction;
    node->cosNormals = 1.0f;
    node->intensity *= e.area;
    if (e.tag != EmitterTag::Triangle) {
        node->radius = e.tag == EmitterTag::Disc
                           ? std::sqrt(lengthSquared(e.axisU) + lengthSquared(e.axisV))
                           : std::max(glm::length(e.axisU + e.axisV), glm::length(e.axisU - e.axisV));
        return;
    }
    Bounds box;
    box.grow(e.position);
    box.grow(e.position + e.axisU);
    box.grow(e.position + e.axisV);
    node->center = box.center();
    node->radius = 0.5f * glm::length(box.extent());
}

/// Where, which way and how strongly a single light shines.
LightNode leafNode(const EmitterData& e) {
    LightNode node;
    node.center = e.position;
    node.intensity = luminance(e.radiance);
    node.bothSides = e.emitsBothSides;
    switch (e.tag) {
        case EmitterTag::Sphere:
        case EmitterTag::Ellipsoid:
            node.radius = e.radiusWorld;
            node.intensity *= kPi * square(e.radiusWorld);
            break;
        case EmitterTag::Rectangle:
        case EmitterTag::Parallelogram:
        case EmitterTag::Disc:
        case EmitterTag::Triangle:
            boundFlat(e, &node);
            break;
        case EmitterTag::Spot:
            node.axis = e.direction;
            node.cosNormals = 1.0f - e.oneMinusCosOuter;
            node.cosEmission = 0.999f;
            break;
        default:
            break;
    }
    node.radius *= 1.0f + 1e-6f;
    if (!std::isfinite(node.intensity)) { node.intensity = 1e30f; }
    return node;
}

class TableBuilder {
  public:
    TableBuilder(const SceneDescription& scene, int threads) : scene_(scene), threads_(threads) {}

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
        if (!material.emissive() || object.shape == ShapeKind::Plane) { return; }
        if (object.shape == ShapeKind::Mesh && !scene_.meshes[static_cast<size_t>(object.mesh)].data) {
            return;
        }
        const size_t first = table_->emitters.size();
        table_->firstEmitter[index] = static_cast<uint32_t>(first);
        switch (object.shape) {
            case ShapeKind::Sphere:
                table_->emitters.push_back(sphereEmitter(object.objectToWorld));
                break;
            case ShapeKind::Mesh:
                addMesh(object, *scene_.meshes[static_cast<size_t>(object.mesh)].data,
                        material.emitsBothSides);
                break;
            default:
                table_->emitters.push_back(flatEmitter(object.objectToWorld, object.shape));
                break;
        }
        for (size_t i = first; i < table_->emitters.size(); ++i) {
            table_->emitters[i].radiance = emittedRadiance(material);
            table_->emitters[i].emitsBothSides = material.emitsBothSides && !object.frontOnly;
            table_->emitters[i].instance = static_cast<uint32_t>(index);
        }
    }

    void addMesh(const Object& object, const MeshData& mesh, bool bothSides) {
        const size_t first = table_->emitters.size();
        const bool mirrored = glm::determinant(glm::dmat3(object.objectToWorld.linear)) < 0.0;
        const std::vector<uint32_t> original = firstOfRepeatedTriangles(mesh, bothSides);
        table_->emitters.resize(first + mesh.triangleCount());
        parallelChunks(mesh.triangleCount(), 1 << 14, threads_, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                EmitterData& e = table_->emitters[first + static_cast<size_t>(i)];
                e = triangleEmitter(object.objectToWorld, mesh, static_cast<uint32_t>(i), mirrored);
                e.original = static_cast<uint32_t>(first) + original[static_cast<size_t>(i)];
                if (original[static_cast<size_t>(i)] != i) { e.area = 0.0f; }
            }
        });
    }

    void addLights(bool directional) {
        for (const Light& light : scene_.lights) {
            if ((light.kind == LightKind::Directional) != directional) { continue; }
            const EmitterData e = pointlikeEmitter(light);
            if (maxComponent(e.radiance) > 0.0f) { table_->emitters.push_back(e); }
        }
    }

    const SceneDescription& scene_;
    const int threads_;
    std::shared_ptr<LightTable> table_ = std::make_shared<LightTable>();
};

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
    table->environmentIrradiance = luminance(table->environmentRadiance) * mean * kPi;
    if (!(table->environmentIrradiance > 0.0f)) { return; }
    EmitterData e;
    e.tag = EmitterTag::Environment;
    table->emitters.push_back(e);
}

void addSelection(LightTable* table) {
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
    FeatureMask mask = usesTree ? kFeatureManyLights : 0u;
    if (std::any_of(firstEmitter.begin(), firstEmitter.end(), [](uint32_t e) { return e != kNone; })) {
        mask |= kFeatureAreaLights;
    }
    for (const EmitterData& e : emitters) {
        const bool delta =
            e.tag == EmitterTag::Point || e.tag == EmitterTag::Spot || e.tag == EmitterTag::Directional;
        if (delta) { mask |= kFeatureDeltaLights; }
    }
    if (maxComponent(environmentRadiance) > 0.0f) {
        mask |= environment ? kFeatureEnvironmentImage : kFeatureEnvironmentConstant;
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
    v.environmentIrradiance = environmentIrradiance;
    v.environmentRadiance = environmentRadiance;
    if (environment) {
        v.environment = environment->view();
        v.environment.cosRotation = std::cos(environmentRotationRad);
        v.environment.sinRotation = std::sin(environmentRotationRad);
    }
    return v;
}

size_t LightTable::bytes() const {
    return emitters.size() * sizeof(EmitterData) + nodes.size() * sizeof(LightNode) +
           (emitterNodes.size() + firstEmitter.size()) * sizeof(uint32_t) +
           (environment ? environment->bytes() : 0);
}

std::shared_ptr<const LightTable> buildLightTable(const SceneDescription& scene, const LightTable* previous,
                                                  int threads) {
    std::shared_ptr<LightTable> table = TableBuilder(scene, threads).build();
    addEnvironment(scene, previous, threads, table.get());
    addSelection(table.get());
    return table;
}

}  // namespace glint

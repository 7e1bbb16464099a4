#include "engine/render/first_frame.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include <glm/matrix.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/camera_builder.h"
#include "engine/builders/scene_validation.h"
#include "engine/io/scene_export.h"
#include "engine/render/depth_buffer.h"
#include "engine/render/preview_scale.h"

namespace glint {
namespace {

constexpr int64_t kMostPixels = 250'000;
constexpr uint64_t kMostTriangles = 20'000'000;  // beyond, drawing takes as long as building
constexpr size_t kMostTurned = 200;              // objects, of some thousand triangles each
constexpr double kNearest = 1e-5;                // of the way to the target

int firstFrameScale(const Resolution& size) {
    int scale = 2;
    const auto pixels = [&] {
        return int64_t{previewSize(size.width, scale)} * int64_t{previewSize(size.height, scale)};
    };
    while (pixels() > kMostPixels && scale < PreviewScale::kMaxScale) {
        ++scale;
    }
    return scale;
}

/// An object's triangles, and how they lie before the camera.
struct PlacedTriangles {
    const MeshData* mesh;
    const Material* material;
    glm::dmat3 toCamera;
    glm::dvec3 translation;
    glm::dmat3 fromCamera;  ///< for normals
    double front;           ///< -1 where the transform mirrors; 0: seen from both sides
    uint32_t first;         ///< the number of its first triangle among all

    uint32_t end() const { return first + mesh->triangleCount(); }
    const uint32_t* indices(uint32_t number) const { return &mesh->indices[3 * size_t{number - first}]; }
    void corners(uint32_t number, CameraTriangle* triangle) const {
        for (int i = 0; i < 3; ++i) {
            (*triangle)[i] = toCamera * glm::dvec3(mesh->positions[indices(number)[i]]) + translation;
        }
    }
};

class FirstFrame {
  public:
    FirstFrame(const SceneDescription& scene, const CameraData& camera, int threads,
               const std::atomic<bool>& stop)
        : scene_(scene), camera_(camera), threads_(threads), stop_(stop) {
        for (const Object& object : scene.objects) {
            if (isTooMuch() || stop_) { return; }
            if (const MeshData* mesh = trianglesOf(object)) { add(object, *mesh); }
        }
    }

    /// Null: it is too much, or was stopped.
    std::shared_ptr<FilmSnapshot> draw() const {
        if (isTooMuch()) { return nullptr; }
        const int scale = firstFrameScale(scene_.resolution);
        const int width = previewSize(scene_.resolution.width, scale);
        const int height = previewSize(scene_.resolution.height, scale);
        const double reach =
            glm::length(glm::dvec3(scene_.camera.target) - glm::dvec3(scene_.camera.position));
        DepthBuffer buffer(camera_, kNearest * reach, width, height);
        drawAll(&buffer);
        if (buffer.isTooMuch() || stop_) { return nullptr; }
        auto frame = std::make_shared<FilmSnapshot>();
        frame->width = width;
        frame->height = height;
        frame->previewScale = scale;
        frame->integrator = scene_.options.integrator;
        frame->isFirstFrame = true;
        frame->passes = 1;
        frame->radiance.resize(3 * static_cast<size_t>(width) * static_cast<size_t>(height));
        parallelChunks(height, 16, threads_, [&](int64_t begin, int64_t end) {
            for (int64_t y = begin; y < end; ++y) {
                shadeRow(buffer, static_cast<int>(y), width, frame->radiance.data() + 3 * y * width);
            }
        });
        return frame;
    }

  private:
    bool isTooMuch() const { return triangles_ > kMostTriangles || turned_.size() > kMostTurned; }

    /// Null: it has none.
    const MeshData* trianglesOf(const Object& object) {
        if (object.shape == ShapeKind::Mesh) {
            return scene_.meshes[static_cast<size_t>(object.mesh)].data.get();
        }
        if (object.shape == ShapeKind::Revolved) { return &turned_.emplace_back(turnedMesh(object)); }
        MeshData& shape = shapes_[object.shape];
        if (shape.indices.empty()) { shape = shapeMesh(object); }
        return &shape;
    }

    void add(const Object& object, const MeshData& mesh) {
        const uint64_t first = triangles_;
        triangles_ += mesh.triangleCount();
        if (triangles_ == first || isTooMuch()) { return; }
        const Frame& frame = camera_.frame;
        const glm::dmat3 toFrame =
            glm::transpose(glm::dmat3(glm::dvec3(frame.s), glm::dvec3(frame.t), glm::dvec3(frame.n)));
        const glm::dmat3 toCamera = toFrame * glm::dmat3(object.objectToWorld.linear);
        const glm::dvec3 translation =
            toFrame * (glm::dvec3(object.objectToWorld.translation) - glm::dvec3(camera_.position));
        const double side = glm::determinant(toCamera) < 0.0 ? -1.0 : 1.0;
        placed_.push_back({&mesh, &scene_.materials[static_cast<size_t>(object.material)], toCamera,
                           translation, glm::inverse(toCamera), object.frontOnly ? side : 0.0,
                           static_cast<uint32_t>(first)});
    }

    /// Of the triangle with this number.
    const PlacedTriangles& placedOf(uint32_t number) const {
        const auto after = std::ranges::upper_bound(placed_, number, {}, &PlacedTriangles::first);
        return *(after - 1);
    }

    void drawAll(DepthBuffer* buffer) const {
        parallelChunks(static_cast<int64_t>(triangles_), 1 << 14, threads_, [&](int64_t begin, int64_t end) {
            if (stop_ || buffer->isTooMuch()) { return; }
            const PlacedTriangles* placed = &placedOf(static_cast<uint32_t>(begin));
            for (auto number = static_cast<uint32_t>(begin); number < end; ++number) {
                while (number >= placed->end()) {
                    ++placed;
                }
                CameraTriangle triangle;
                placed->corners(number, &triangle);
                if (!isBackOfOneSided(*placed, triangle)) { buffer->draw(triangle, number); }
            }
        });
    }

    bool isBackOfOneSided(const PlacedTriangles& placed, const CameraTriangle& triangle) const {
        if (placed.front == 0.0) { return false; }
        const glm::dvec3 normal =
            placed.front * glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
        return glm::dot(normal, camera_.isOrthographic ? glm::dvec3(0, 0, -1) : triangle[0]) >= 0.0;
    }

    void shadeRow(const DepthBuffer& buffer, int y, int width, float* rgb) const {
        for (int x = 0; x < width; ++x, rgb += 3) {
            Vec3 color = scene_.environment.color;
            if (!buffer.isEmpty(x, y)) {
                glm::dvec3 origin, direction;
                buffer.ray(x, y, &origin, &direction);
                color = shade(buffer.number(x, y), origin, direction);
            }
            std::copy_n(&color.x, 3, rgb);
        }
    }

    /// As the ray caster without lamps: by the cosine of the angle to the viewer.
    Vec3 shade(uint32_t number, const glm::dvec3& origin, const glm::dvec3& direction) const {
        const PlacedTriangles& placed = placedOf(number);
        CameraTriangle corner;
        placed.corners(number, &corner);
        const glm::dvec3 ab = corner[1] - corner[0], ac = corner[2] - corner[0];
        const glm::dvec3 face = glm::cross(ab, ac);
        const double t = glm::dot(face, corner[0] - origin) / glm::dot(face, direction);
        const glm::dvec3 p = origin + t * direction - corner[0];
        // A ray along the triangle meets it nowhere in particular.
        const auto share = [&](double volume) {
            const double part = volume / glm::dot(face, face);
            return part > 0.0 ? std::min(part, 1.0) : 0.0;
        };
        const double ofB = share(glm::dot(glm::cross(p, ac), face));
        const double ofC = std::min(share(glm::dot(glm::cross(ab, p), face)), 1.0 - ofB);
        const auto mixed = [&](const std::vector<Vec3>& values) {
            const uint32_t* index = placed.indices(number);
            return glm::dvec3(values[index[0]]) * (1.0 - ofB - ofC) + glm::dvec3(values[index[1]]) * ofB +
                   glm::dvec3(values[index[2]]) * ofC;
        };
        double cosine = std::fabs(glm::dot(face, direction)) / glm::length(face);
        if (!placed.mesh->normals.empty()) {
            const glm::dvec3 normal = mixed(placed.mesh->normals) * placed.fromCamera;
            const double smooth = std::fabs(glm::dot(normal, direction)) / glm::length(normal);
            cosine = smooth <= 1.0 ? smooth : cosine;
        }
        Vec3 albedo = placed.material->color.value;
        if (!placed.mesh->colors.empty()) { albedo *= Vec3(mixed(placed.mesh->colors)); }
        const float lit = cosine <= 1.0 ? static_cast<float>(cosine) : 1.0f;
        return emissionOf(*placed.material) + albedo * (scene_.rayCast.ambient + lit);
    }

    /// White at most.
    static Vec3 emissionOf(const Material& material) {
        return glm::min(material.emission.value * material.emissionStrength, Vec3(1.0f));
    }

    const SceneDescription& scene_;
    const CameraData& camera_;
    int threads_;
    const std::atomic<bool>& stop_;
    std::map<ShapeKind, MeshData> shapes_;
    std::deque<MeshData> turned_;
    uint64_t triangles_ = 0;  ///< of all objects
    std::vector<PlacedTriangles> placed_;
};

}  // namespace

std::shared_ptr<FilmSnapshot> drawFirstFrame(const SceneDescription& scene, int threads,
                                             const std::atomic<bool>& stop) {
    if (!validateScene(scene, EditKind::Everything)) { return nullptr; }
    const float aspect =
        static_cast<float>(scene.resolution.width) / static_cast<float>(scene.resolution.height);
    const Result<CameraData> camera = buildCamera(scene.camera, aspect);
    return camera ? FirstFrame(scene, *camera, threads, stop).draw() : nullptr;
}

}  // namespace glint

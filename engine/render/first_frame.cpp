#include "engine/render/first_frame.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <deque>
#include <limits>
#include <map>
#include <unordered_set>
#include <utility>
#include <vector>

#include <glm/matrix.hpp>

#include "engine/base/parallel.h"
#include "engine/builders/camera_builder.h"
#include "engine/builders/mesh_builder.h"
#include "engine/builders/scene_validation.h"
#include "engine/io/scene_export.h"
#include "engine/kernels/shapes/object_point.h"
#include "engine/render/preview_scale.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

constexpr int64_t kMostPixels = 250'000;
constexpr uint64_t kMostTriangles = 20'000'000;  // beyond, drawing takes as long as building
constexpr float kNearest = 1e-5f;  // depth in front of which nothing is drawn, of the way to the target

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

/// An object's triangles, and how they lie before the camera, which looks along -z.
struct PlacedTriangles {
    const MeshData* mesh;
    const Material* material;
    Affine toCamera;
    Mat3 fromCamera;  ///< for normals
    float front;      ///< -1 where the transform mirrors; 0: seen from both sides
    uint32_t first;   ///< the number of its first triangle among all

    uint32_t end() const { return first + mesh->triangleCount(); }
    void corners(uint32_t triangle, Vec3 (&corner)[3]) const {
        for (size_t i = 0; i < 3; ++i) {
            corner[i] = toCamera.point(mesh->positions[mesh->indices[3 * size_t{triangle} + i]]);
        }
    }
};

/// In pixels, from the picture's top left corner; `inverse` of the depth, which is linear over the picture.
struct ProjectedPoint {
    double x, y, inverse;
};

/// The triangle that is nearest in each pixel's middle. Threads may draw at once: what stays does not depend
/// on the order.
class DepthBuffer {
  public:
    DepthBuffer(const CameraData& camera, float nearest, int width, int height)
        : camera_(camera),
          nearest_(nearest),
          width_(width),
          height_(height),
          pixels_(static_cast<size_t>(width) * static_cast<size_t>(height), kEmpty) {}

    /// In camera space.
    void draw(const Vec3 (&corner)[3], uint32_t number) {
        Vec3 kept[4];
        int count = 0;
        for (int i = 0; i < 3; ++i) {
            const Vec3 &a = corner[i], &b = corner[(i + 1) % 3];
            if (-a.z >= nearest_) { kept[count++] = a; }
            if ((-a.z >= nearest_) != (-b.z >= nearest_)) {
                kept[count++] = a + (b - a) * ((a.z + nearest_) / (a.z - b.z));
            }
        }
        for (int i = 2; i < count; ++i) {
            fill(project(kept[0]), project(kept[i - 1]), project(kept[i]), number);
        }
    }

    /// The ray through a pixel's middle, in camera space.
    void ray(int x, int y, Vec3* origin, Vec3* direction) const {
        const float right = 2.0f * (static_cast<float>(x) + 0.5f) / static_cast<float>(width_) - 1.0f;
        const float up = 1.0f - 2.0f * (static_cast<float>(y) + 0.5f) / static_cast<float>(height_);
        const Vec3 place(right * camera_.halfWidth + camera_.middle.x,
                         up * camera_.halfHeight + camera_.middle.y, 0.0f);
        *origin = camera_.isOrthographic ? place : Vec3(0.0f);
        *direction = camera_.isOrthographic ? Vec3(0, 0, -1) : glm::normalize(place + Vec3(0, 0, -1));
    }

    bool isEmpty(size_t pixel) const { return pixels_[pixel] == kEmpty; }
    uint32_t number(size_t pixel) const { return static_cast<uint32_t>(pixels_[pixel]); }

  private:
    static constexpr uint64_t kEmpty = std::numeric_limits<uint64_t>::max();

    ProjectedPoint project(const Vec3& p) const {
        const double depth = -static_cast<double>(p.z), w = camera_.isOrthographic ? 1.0 : depth;
        const auto across = [&](float place, float middle, float half) {
            return (static_cast<double>(place) / w - static_cast<double>(middle)) / static_cast<double>(half);
        };
        return {0.5 * width_ * (1.0 + across(p.x, camera_.middle.x, camera_.halfWidth)),
                0.5 * height_ * (1.0 - across(p.y, camera_.middle.y, camera_.halfHeight)), 1.0 / depth};
    }

    /// The first pixel whose middle is not before x, and at most `end`.
    static int pixelFrom(double x, int end) {
        return static_cast<int>(std::clamp(std::ceil(x - 0.5), 0.0, static_cast<double>(end)));
    }

    void fill(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& c, uint32_t number) {
        const int x0 = pixelFrom(std::min({a.x, b.x, c.x}), width_);
        const int x1 = pixelFrom(std::max({a.x, b.x, c.x}), width_);
        const int y0 = pixelFrom(std::min({a.y, b.y, c.y}), height_);
        const int y1 = pixelFrom(std::max({a.y, b.y, c.y}), height_);
        const double area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (x0 >= x1 || y0 >= y1 || !(std::fabs(area) > 0.0) || !std::isfinite(area)) { return; }
        for (int y = y0; y < y1; ++y) {
            for (int x = x0; x < x1; ++x) {
                const double px = x + 0.5, py = y + 0.5;
                const double ofB = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area;
                const double ofC = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
                if (!(ofB >= 0.0 && ofC >= 0.0 && ofB + ofC <= 1.0)) { continue; }
                const double inverse = depthWeight(a, b, c, ofB, ofC);
                keepNearest(static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x),
                            static_cast<float>(1.0 / inverse), number);
            }
        }
    }

    double depthWeight(const ProjectedPoint& a, const ProjectedPoint& b, const ProjectedPoint& c, double ofB,
                       double ofC) const {
        const double ofA = 1.0 - ofB - ofC;
        if (!camera_.isOrthographic) { return ofA * a.inverse + ofB * b.inverse + ofC * c.inverse; }
        return 1.0 / (ofA / a.inverse + ofB / b.inverse + ofC / c.inverse);
    }

    /// Depths are positive, so that their bits are in their order.
    void keepNearest(size_t pixel, float depth, uint32_t number) {
        if (!(depth > 0.0f)) { return; }
        const uint64_t candidate = uint64_t{std::bit_cast<uint32_t>(depth)} << 32 | number;
        std::atomic_ref<uint64_t> kept(pixels_[pixel]);
        uint64_t before = kept.load(std::memory_order_relaxed);
        while (candidate < before &&
               !kept.compare_exchange_weak(before, candidate, std::memory_order_relaxed)) {}
    }

    const CameraData& camera_;
    float nearest_;
    int width_, height_;
    std::vector<uint64_t> pixels_;  ///< depth, and the triangle's number
};

class FirstFrame {
  public:
    FirstFrame(const SceneDescription& scene, const CameraData& camera, int threads)
        : scene_(scene), camera_(camera), threads_(threads) {
        for (const Object& object : scene.objects) {
            if (const MeshData* mesh = trianglesOf(object)) { add(object, *mesh); }
        }
    }

    bool isTooMuch() const { return triangles_ > kMostTriangles; }

    std::shared_ptr<FilmSnapshot> draw() const {
        const int scale = firstFrameScale(scene_.resolution);
        const int width = previewSize(scene_.resolution.width, scale);
        const int height = previewSize(scene_.resolution.height, scale);
        const float reach = glm::length(scene_.camera.target - scene_.camera.position);
        DepthBuffer buffer(camera_, std::max(kNearest * reach, std::numeric_limits<float>::min()), width,
                           height);
        drawAll(&buffer);
        auto frame = std::make_shared<FilmSnapshot>();
        frame->width = width;
        frame->height = height;
        frame->previewScale = scale;
        frame->integrator = IntegratorKind::RayCast;
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
    /// Null: it has none.
    const MeshData* trianglesOf(const Object& object) {
        if (object.shape == ShapeKind::Mesh) {
            return scene_.meshes[static_cast<size_t>(object.mesh)].data.get();
        }
        if (object.shape == ShapeKind::Revolved) { return &turned_.emplace_back(turnedMesh(object)); }
        auto& shape = shapes_[object.shape];
        if (shape.indices.empty()) { shape = shapeMesh(object); }
        return &shape;
    }

    void add(const Object& object, const MeshData& mesh) {
        const uint64_t first = triangles_;
        triangles_ += mesh.triangleCount();
        if (triangles_ == first || isTooMuch()) { return; }
        Affine toCamera;
        for (int axis = 0; axis < 3; ++axis) {
            toCamera.linear[axis] = camera_.frame.toLocal(object.objectToWorld.linear[axis]);
        }
        toCamera.translation = camera_.frame.toLocal(object.objectToWorld.translation - camera_.position);
        const float side = toCamera.determinant() < 0.0f ? -1.0f : 1.0f;
        placed_.push_back({&mesh, &scene_.materials[static_cast<size_t>(object.material)], toCamera,
                           glm::inverse(toCamera.linear), object.frontOnly ? side : 0.0f,
                           static_cast<uint32_t>(first)});
    }

    /// Of the triangle with this number.
    const PlacedTriangles& placedOf(uint32_t number) const {
        const auto after = std::ranges::upper_bound(placed_, number, {}, &PlacedTriangles::first);
        return *(after - 1);
    }

    void drawAll(DepthBuffer* buffer) const {
        if (placed_.empty()) { return; }
        parallelChunks(static_cast<int64_t>(triangles_), 1 << 14, threads_, [&](int64_t begin, int64_t end) {
            const PlacedTriangles* placed = &placedOf(static_cast<uint32_t>(begin));
            for (uint32_t number = static_cast<uint32_t>(begin); number < end; ++number) {
                while (number >= placed->end()) {
                    ++placed;
                }
                Vec3 corner[3];
                placed->corners(number - placed->first, corner);
                if (!isBackOfOneSided(*placed, corner)) { buffer->draw(corner, number); }
            }
        });
    }

    bool isBackOfOneSided(const PlacedTriangles& placed, const Vec3 (&corner)[3]) const {
        if (placed.front == 0.0f) { return false; }
        const Vec3 normal = placed.front * glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        return glm::dot(normal, camera_.isOrthographic ? Vec3(0, 0, -1) : corner[0]) >= 0.0f;
    }

    void shadeRow(const DepthBuffer& buffer, int y, int width, float* rgb) const {
        for (int x = 0; x < width; ++x, rgb += 3) {
            const size_t pixel = static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x);
            Vec3 color = scene_.environment.color;
            if (!buffer.isEmpty(pixel)) {
                Vec3 origin, direction;
                buffer.ray(x, y, &origin, &direction);
                color = shade(placedOf(buffer.number(pixel)), buffer.number(pixel), origin, direction);
            }
            std::copy_n(&color.x, 3, rgb);
        }
    }

    /// As the ray caster without lamps: the cosine of the angle to the viewer.
    Vec3 shade(const PlacedTriangles& placed, uint32_t number, const Vec3& origin,
               const Vec3& direction) const {
        const uint32_t triangle = number - placed.first;
        Vec3 corner[3];
        placed.corners(triangle, corner);
        const Vec3 face = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
        const float t = glm::dot(face, corner[0] - origin) / glm::dot(face, direction);
        const Vec3 p = origin + t * direction - corner[0];
        const float area2 = glm::dot(face, face);
        const float ofB = glm::dot(glm::cross(p, corner[2] - corner[0]), face) / area2;
        const float ofC = glm::dot(glm::cross(corner[1] - corner[0], p), face) / area2;
        const auto mixed = [&](const std::vector<Vec3>& values) {
            const uint32_t* index = &placed.mesh->indices[3 * size_t{triangle}];
            return values[index[0]] * (1.0f - ofB - ofC) + values[index[1]] * ofB + values[index[2]] * ofC;
        };
        Vec3 normal = normalizeOr(face, Vec3(0, 0, 1));
        if (!placed.mesh->normals.empty()) {
            normal = normalizeOr(mixed(placed.mesh->normals) * placed.fromCamera, normal);
        }
        Vec3 albedo = placed.material->color.value;
        if (!placed.mesh->colors.empty()) { albedo *= mixed(placed.mesh->colors); }
        const float cosine = std::fabs(glm::dot(normal, direction));
        return emissionOf(*placed.material) + albedo * (scene_.rayCast.ambient + cosine);
    }

    /// White at most.
    static Vec3 emissionOf(const Material& material) {
        return glm::min(material.emission.value * material.emissionStrength, Vec3(1.0f));
    }

    const SceneDescription& scene_;
    const CameraData& camera_;
    int threads_;
    std::map<ShapeKind, MeshData> shapes_;
    std::deque<MeshData> turned_;
    uint64_t triangles_ = 0;  ///< of all objects
    std::vector<PlacedTriangles> placed_;
};

}  // namespace

std::shared_ptr<FilmSnapshot> drawFirstFrame(const SceneDescription& scene, int threads) {
    const float aspect =
        static_cast<float>(scene.resolution.width) / static_cast<float>(scene.resolution.height);
    const Result<CameraData> camera = buildCamera(scene.camera, aspect);
    if (!camera || !validateScene(scene, EditKind::Everything)) { return nullptr; }
    const FirstFrame frame(scene, *camera, threads);
    return frame.isTooMuch() ? nullptr : frame.draw();
}

size_t trianglesToBuild(const SceneDescription& scene, const BuiltScene* previous) {
    std::unordered_set<const MeshData*> known;
    if (previous != nullptr) {
        for (const auto& mesh : previous->meshes) {
            if (mesh->isReady) { known.insert(mesh->data.get()); }
        }
    }
    const std::vector<bool> used = usedMeshes(scene);
    size_t triangles = 0;
    for (size_t i = 0; i < used.size(); ++i) {
        const MeshData* data = scene.meshes[i].data.get();
        if (used[i] && data != nullptr && known.insert(data).second) { triangles += data->triangleCount(); }
    }
    return triangles;
}

}  // namespace glint

// The only file that knows Embree's interface.
#include "viewer/bench/embree_oracle.h"

#if GLINT_HAS_EMBREE

#include <chrono>
#include <string>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "engine/base/parallel.h"

namespace glint {

struct EmbreeOracle::Scene {
    std::shared_ptr<const MeshData> mesh;
    std::vector<float> paddedPositions;  // Embree reads 16 bytes at the last vertex too
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    double buildSeconds = 0.0;
};

namespace {

RTCRay toEmbree(const Ray& ray) {
    RTCRay r{};
    r.org_x = ray.origin.x;
    r.org_y = ray.origin.y;
    r.org_z = ray.origin.z;
    r.tnear = ray.tMin;
    r.dir_x = ray.direction.x;
    r.dir_y = ray.direction.y;
    r.dir_z = ray.direction.z;
    r.tfar = ray.tMax;
    r.mask = ~0u;
    return r;
}

RTCGeometry makeGeometry(RTCDevice device, const MeshData& mesh, const std::vector<float>& positions) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, positions.data(), 0,
                               sizeof(Vec3), mesh.positions.size());
    rtcSetSharedGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, mesh.indices.data(), 0,
                               3 * sizeof(uint32_t), mesh.triangleCount());
    rtcSetGeometryBuildQuality(geometry, RTC_BUILD_QUALITY_HIGH);
    rtcCommitGeometry(geometry);
    return geometry;
}

}  // namespace

bool EmbreeOracle::available() { return true; }

const char* EmbreeOracle::version() { return RTC_VERSION_STRING; }

EmbreeOracle::EmbreeOracle(std::shared_ptr<const MeshData> mesh, int threads)
    : scene_(std::make_unique<Scene>()) {
    scene_->mesh = std::move(mesh);
    for (const Vec3& p : scene_->mesh->positions) {
        scene_->paddedPositions.insert(scene_->paddedPositions.end(), {p.x, p.y, p.z});
    }
    scene_->paddedPositions.push_back(0.0f);
    const int used = threads > 0 ? threads : defaultThreadCount();
    scene_->device = rtcNewDevice(fmt::format("threads={}", used).c_str());
    scene_->scene = rtcNewScene(scene_->device);
    rtcSetSceneFlags(scene_->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_->scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = makeGeometry(scene_->device, *scene_->mesh, scene_->paddedPositions);
    rtcAttachGeometry(scene_->scene, geometry);
    rtcReleaseGeometry(geometry);
    const auto start = std::chrono::steady_clock::now();
    rtcCommitScene(scene_->scene);
    scene_->buildSeconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

EmbreeOracle::~EmbreeOracle() {
    rtcReleaseScene(scene_->scene);
    rtcReleaseDevice(scene_->device);
}

double EmbreeOracle::buildSeconds() const { return scene_->buildSeconds; }

bool EmbreeOracle::intersect(const Ray& ray, Hit* hit) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query{};
    query.ray = toEmbree(ray);
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_->scene, &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) { return false; }
    *hit = {query.ray.tfar, 0, query.hit.primID, Vec2(query.hit.u, query.hit.v)};
    return true;
}

bool EmbreeOracle::occluded(const Ray& ray) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRay query = toEmbree(ray);
    rtcOccluded1(scene_->scene, &context, &query);
    return query.tfar < 0.0f;
}

}  // namespace glint

#else

namespace glint {

struct EmbreeOracle::Scene {};

bool EmbreeOracle::available() { return false; }
const char* EmbreeOracle::version() { return ""; }
EmbreeOracle::EmbreeOracle(std::shared_ptr<const MeshData>, int) {}
EmbreeOracle::~EmbreeOracle() = default;
double EmbreeOracle::buildSeconds() const { return 0.0; }
bool EmbreeOracle::intersect(const Ray&, Hit*) const { return false; }
bool EmbreeOracle::occluded(const Ray&) const { return false; }

}  // namespace glint

#endif

// Embree behind three functions: the yardstick of `glint bench rays` and the oracle of the
// intersection tests.
//
// Without Embree at compile time available() is false and nothing else may be called. Never part of a render.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/kernels/intersect.h"
#include "engine/scene/mesh_data.h"

namespace glint {

class EmbreeOracle {
  public:
    static bool available();
    static const char* version();

    /// Builds one mesh in high quality with RTC_SCENE_FLAG_ROBUST on `threads` threads (0: all).
    EmbreeOracle(std::shared_ptr<const MeshData> mesh, int threads);
    ~EmbreeOracle();
    EmbreeOracle(const EmbreeOracle&) = delete;
    EmbreeOracle& operator=(const EmbreeOracle&) = delete;

    double buildSeconds() const;
    /// rtcIntersect1; hit->instance is 0. Barycentric weights as Glint's.
    bool intersect(const Ray& ray, Hit* hit) const;
    /// rtcOccluded1.
    bool occluded(const Ray& ray) const;

  private:
    struct Scene;
    std::unique_ptr<Scene> scene_;
};

}  // namespace glint

// What happens along one path, event by event, for replay (render/path_replay). The kernels take a log as a
// template parameter; with NoPathLog every call disappears.
#pragma once

#include "engine/kernels/geometry_view.h"
#include "engine/kernels/pass.h"
#include "engine/math/vec.h"

namespace glint {

enum class PathEventKind : uint8_t {
    Camera,    ///< position, direction of the camera ray
    Vertex,    ///< a surface was met: position, normal (shading), instance, primitive, material
    Emission,  ///< the surface shines: value = what it adds, pdfs of both strategies, weight
    Escape,    ///< the ray left the scene: value = what the environment adds, pdfs, weight
    Light,     ///< a light was sampled: value = what it adds (0 when shadowed), pdfs, weight, emitter
    Scatter,   ///< a direction was sampled: direction, value = its weight, pdfBsdf
    Roulette,  ///< weight = probability of going on; `flag`: went on
    End,       ///< value = the path's radiance before faults and clamps
};

/// One event. Fields that its kind does not name are at their defaults.
struct PathEvent {
    PathEventKind kind = PathEventKind::End;
    int depth = 0;  ///< scattering events before this one
    Vec3 position{0.0f};
    Vec3 normal{0.0f};
    Vec3 direction{0.0f};
    Vec3 value{0.0f};
    Vec3 throughput{1.0f};  ///< before this event
    float pdfLight = 0.0f;  ///< per solid angle, choice of the light included
    float pdfBsdf = 0.0f;   ///< per solid angle
    float weight = 1.0f;    ///< MIS weight, or the roulette's probability
    uint32_t instance = kNone;
    uint32_t primitive = kNone;
    uint32_t material = kNone;
    uint32_t emitter = kNone;
    bool flag = false;                      ///< Light: shadowed; Scatter: specular; Roulette: went on
    SampleFault fault = SampleFault::None;  ///< End only
};

struct NoPathLog {
    static constexpr bool kEnabled = false;
    GLINT_HD void add(const PathEvent&) {}
};

}  // namespace glint

// Light sampling: one light and one point on it for a place, and the density with which a direction found
// otherwise would have been sampled.
#pragma once

#include "engine/kernels/emitted_radiance.h"
#include "engine/kernels/environment.h"
#include "engine/kernels/light_tree.h"
#include "engine/kernels/scene_view.h"
#include "engine/kernels/shapes/shapes.h"
#include "engine/math/equal_area.h"

namespace glint {

/// Light from one direction. Without shadows: whether it arrives is for a shadow ray to find out.
struct LightSample {
    Vec3 wiWorld{0.0f};          ///< unit, from the place towards the light
    Vec3 point{0.0f};            ///< on the light; meaningless when isInfinite
    Vec3 pointError{0.0f};       ///< bound of its absolute rounding error
    Vec3 pointNormal{0.0f};      ///< unit; 0 for lights that are points
    Vec3 radiance{0.0f};         ///< delta lights: irradiance facing the light; otherwise radiance
    float pdfSolidAngle = 0.0f;  ///< choice of the light included; delta lights: only that. 0: no sample
    uint32_t emitter = 0;
    bool isDelta = false;
    bool isInfinite = false;
};

/// 1 inside the inner cone, 0 outside the outer one, smooth (cubic) in the cosine between.
GLINT_HD inline float spotFalloff(const EmitterData& e, float oneMinusCos) {
    if (oneMinusCos <= e.oneMinusCosInner) { return 1.0f; }
    if (oneMinusCos >= e.oneMinusCosOuter) { return 0.0f; }
    const float t = (e.oneMinusCosOuter - oneMinusCos) / (e.oneMinusCosOuter - e.oneMinusCosInner);
    return t * t * (3.0f - 2.0f * t);
}

/// A point of an emissive shape as seen from `from`.
template <FeatureMask kMask>
GLINT_HD inline EmitterPoint sampleEmitterShape(const SceneView& view, const EmitterData& e, const Vec3& from,
                                                const Vec2& u) {
    return visitShape<EmitterPoint, kMask>(
        e.shape, [&](auto shape) { return decltype(shape)::sampleFrom(view.geometry, e, from, u); });
}

/// Density per solid angle at `from` with which sampleEmitterShape() finds the point `p` of the emitter.
template <FeatureMask kMask>
GLINT_HD inline float pdfEmitterShape(const SceneView& view, const EmitterData& e, const Vec3& from,
                                      const Vec3& p) {
    return visitShape<float, kMask>(
        e.shape, [&](auto shape) { return decltype(shape)::pdfFrom(view.geometry, e, from, p); });
}

template <FeatureMask kMask>
GLINT_HD inline LightSample sampleAreaLight(const SceneView& view, const EmitterData& e, const Vec3& from,
                                            const Vec2& u) {
    LightSample s;
    const EmitterPoint point = sampleEmitterShape<kMask>(view, e, from, u);
    const Vec3 d = point.p - from;
    const float distance2 = lengthSquared(d);
    if (!(point.pdf > 0.0f) || !(distance2 > 0.0f)) { return s; }
    s.wiWorld = d * (1.0f / std::sqrt(distance2));
    if (!e.emitsBothSides && glm::dot(s.wiWorld, point.normal) >= 0.0f) { return s; }
    s.point = point.p;
    s.pointError = point.pError;
    s.pointNormal = point.normal;
    s.radiance = emitterRadiance<kMask>(view, e, point.p);
    s.pdfSolidAngle = point.pdf;
    return s;
}

/// What a projector sends into a unit direction, W/sr: as much as lights the plane at a distance of 1 with
/// its picture. `cosine`: of the angle to its axis.
template <FeatureMask kMask>
GLINT_HD inline Vec3 projectedIntensity(const SceneView& view, const EmitterData& e, const Vec3& direction,
                                        float* cosine) {
    *cosine = glm::dot(direction, e.direction);
    if (!(*cosine > 0.0f)) { return Vec3(0.0f); }
    const Vec2 place(glm::dot(direction, e.axisU) / (*cosine * lengthSquared(e.axisU)),
                     glm::dot(direction, e.axisV) / (*cosine * lengthSquared(e.axisV)));
    if (!(std::fabs(place.x) <= 1.0f && std::fabs(place.y) <= 1.0f)) { return Vec3(0.0f); }
    const Vec3 irradiance = e.radiance * (1.0f / (*cosine * *cosine * *cosine));
    if (e.original >= view.textures.count) { return irradiance; }
    const Vec2 uv = 0.5f * place + Vec2(0.5f);
    return irradiance * glm::max(sampleTexture<kMask>(view.textures[e.original], uv), Vec3(0.0f));
}

/// What a goniometric light sends into a unit direction, W/sr.
template <FeatureMask kMask>
GLINT_HD inline Vec3 goniometricIntensity(const SceneView& view, const EmitterData& e,
                                          const Vec3& direction) {
    if (e.original >= view.textures.count) { return e.radiance; }
    const Vec2 uv = equalAreaPoint(
        Vec3(glm::dot(direction, e.axisU), glm::dot(direction, e.axisV), glm::dot(direction, e.direction)));
    return e.radiance * glm::max(sampleTexture<kMask>(view.textures[e.original], uv), Vec3(0.0f));
}

template <FeatureMask kMask>
GLINT_HD inline LightSample sampleDeltaLight(const SceneView& view, const EmitterData& e, const Vec3& from) {
    LightSample s;
    s.isDelta = true;
    if (e.kind == EmitterKind::Directional) {
        s.wiWorld = -e.direction;
        s.radiance = e.radiance;
        s.isInfinite = true;
        s.pdfSolidAngle = 1.0f;
        return s;
    }
    const Vec3 d = e.position - from;
    const float distance2 = lengthSquared(d);
    if (!(distance2 > 0.0f)) { return s; }
    s.wiWorld = d * (1.0f / std::sqrt(distance2));
    s.point = e.position;
    s.radiance = e.radiance * (1.0f / distance2);
    if (e.kind == EmitterKind::Spot) {
        s.radiance *= spotFalloff(e, 0.5f * lengthSquared(s.wiWorld + e.direction));
    }
    if constexpr (hasFeature<kMask>(kFeatureProjectors)) {
        if (e.kind == EmitterKind::Projector) {
            float cosine;
            s.radiance = projectedIntensity<kMask>(view, e, -s.wiWorld, &cosine) * (1.0f / distance2);
        }
        if (e.kind == EmitterKind::Goniometric) {
            s.radiance = goniometricIntensity<kMask>(view, e, -s.wiWorld) * (1.0f / distance2);
        }
    }
    s.pdfSolidAngle = isZero(s.radiance) ? 0.0f : 1.0f;
    return s;
}

template <FeatureMask kMask>
GLINT_HD inline LightSample sampleEnvironmentLight(const SceneView& view, const LightContext& at,
                                                   const Vec2& u) {
    LightSample s;
    const DirectionSample direction = sampleEnvironment<kMask>(view.lights, at, u);
    s.wiWorld = direction.wiWorld;
    s.pdfSolidAngle = direction.pdfSolidAngle;
    s.radiance = s.pdfSolidAngle > 0.0f ? environmentRadiance<kMask>(view, s.wiWorld) : Vec3(0.0f);
    s.isInfinite = true;
    return s;
}

/// A sample of one given light, as if it had been chosen with certainty.
template <FeatureMask kMask>
GLINT_HD inline LightSample sampleEmitter(const SceneView& view, const LightContext& at, const EmitterData& e,
                                          const Vec2& u) {
    constexpr bool kEnvironment =
        hasFeature<kMask>(kFeatureEnvironmentConstant) || hasFeature<kMask>(kFeatureEnvironmentImage);
    if constexpr (hasFeature<kMask>(kFeatureDeltaLights)) {
        if (isDeltaLight(e.kind)) { return sampleDeltaLight<kMask>(view, e, at.p); }
    }
    if constexpr (kEnvironment) {
        if (e.kind == EmitterKind::Environment) { return sampleEnvironmentLight<kMask>(view, at, u); }
    }
    if constexpr (hasFeature<kMask>(kFeatureAreaLights)) { return sampleAreaLight<kMask>(view, e, at.p, u); }
    return {};
}

/// Chooses a light by uChoice and a point on it by uPoint, all in [0, 1).
template <FeatureMask kMask>
GLINT_HD inline LightSample sampleLight(const SceneView& view, const LightContext& at, float uChoice,
                                        const Vec2& uPoint) {
    const LightChoice choice = chooseLight<kMask>(view.lights, at, uChoice);
    LightSample s = choice.probability > 0.0f
                        ? sampleEmitter<kMask>(view, at, view.lights.emitters[choice.emitter], uPoint)
                        : LightSample{};
    s.emitter = choice.emitter;
    s.pdfSolidAngle *= choice.probability;
    return s;
}

/// Density with which sampleLight() finds the point `p` of an area emitter from a place; 0: it never does.
template <FeatureMask kMask>
GLINT_HD inline float pdfLightSurface(const SceneView& view, const LightContext& at, uint32_t emitter,
                                      const Vec3& p) {
    if (emitter == kNone) { return 0.0f; }
    const float probability = lightProbability<kMask>(view.lights, at, emitter);
    return probability > 0.0f
               ? probability * pdfEmitterShape<kMask>(view, view.lights.emitters[emitter], at.p, p)
               : 0.0f;
}

/// Density with which sampleLight() finds the unit direction wiWorld by way of the environment.
template <FeatureMask kMask>
GLINT_HD inline float pdfLightEnvironment(const SceneView& view, const LightContext& at,
                                          const Vec3& wiWorld) {
    const LightView& lights = view.lights;
    if (lights.emitters.count == 0) { return 0.0f; }
    const uint32_t last = lights.emitters.count - 1;
    if (lights.emitters[last].kind != EmitterKind::Environment) { return 0.0f; }
    const float probability = lightProbability<kMask>(lights, at, last);
    return probability > 0.0f ? probability * pdfEnvironment<kMask>(lights, at, wiWorld) : 0.0f;
}

/// The emitter of a hit: the index of the emissive triangle or shape, or kNone where light sampling
/// never comes.
GLINT_HD inline uint32_t emitterOf(const SceneView& view, uint32_t instance, uint32_t primitive) {
    const InstanceData& data = view.geometry.instances[instance];
    if (data.firstEmitter == kNone) { return kNone; }
    if (data.shape != ShapeKind::Mesh) { return data.firstEmitter; }
    return view.lights.emitters[data.firstEmitter + primitive].original;
}

}  // namespace glint

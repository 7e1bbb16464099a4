// Which light to sample from a place, and with what probability it would have been chosen.
//
// Lights with a place are weighed by a bound of what they can send to the place (Conty Estevez and Kulla
// 2018, "Importance Sampling of Many Lights with Adaptive Tree Splitting"): one by one when they are few,
// down a binary tree when they are many. Lights infinitely far away are weighed by their irradiance.
#pragma once

#include "engine/kernels/features.h"
#include "engine/kernels/light_view.h"
#include "engine/math/rng.h"

namespace glint {

/// A place that light is gathered at.
struct LightContext {
    Vec3 p{0.0f};
    Vec3 n{0.0f};            ///< unit geometric normal, on the side the path came from
    bool bothSides = false;  ///< the surface transmits: light from behind counts too
};

/// cos(max(0, a - b)) of two angles in [0, pi] given by their sines and cosines.
GLINT_HD inline float cosDifferenceClamped(float sinA, float cosA, float sinB, float cosB) {
    return cosA > cosB ? 1.0f : cosA * cosB + sinA * sinB;
}
GLINT_HD inline float sinDifferenceClamped(float sinA, float cosA, float sinB, float cosB) {
    return cosA > cosB ? 0.0f : sinA * cosB - cosA * sinB;
}
GLINT_HD inline float sinFromCos(float cosine) { return safeSqrt(1.0f - cosine * cosine); }

/// Grazing light keeps this share of its weight: glossy lobes can still be bright there.
constexpr float kGrazingWeight = 0.1f;

/// About the irradiance that the lights of a node can cause at a place; 0 only where they cannot cause any.
GLINT_HD inline float lightImportance(const LightNode& node, const LightContext& at) {
    const Vec3 d = node.center - at.p;
    const float distance2 = lengthSquared(d);
    const float radius2 = node.radius * node.radius;
    const float weight = minf(node.intensity / maxf(maxf(distance2, radius2), 1e-30f), 1e30f);
    if (!(distance2 > radius2)) { return weight; }

    const float inverseDistance = 1.0f / std::sqrt(distance2);
    const float sinSpread = node.radius * inverseDistance;
    const float cosSpread = safeSqrt(1.0f - sinSpread * sinSpread);

    float cosReceiver = glm::dot(at.n, d) * inverseDistance;
    if (at.bothSides) { cosReceiver = std::fabs(cosReceiver); }
    const float cosReceiverBest =
        cosDifferenceClamped(sinFromCos(cosReceiver), cosReceiver, sinSpread, cosSpread);
    if (cosReceiverBest <= 0.0f) { return 0.0f; }

    // Where light leaves around all directions, one of them leads here.
    float cosEmitterBest = 1.0f;
    if (node.cosNormals > -1.0f) {
        float cosAxis = -glm::dot(node.axis, d) * inverseDistance;
        if (node.bothSides) { cosAxis = std::fabs(cosAxis); }
        const float sinAxis = sinFromCos(cosAxis);
        const float sinNormals = sinFromCos(node.cosNormals);
        const float cosToNormals = cosDifferenceClamped(sinAxis, cosAxis, sinNormals, node.cosNormals);
        const float sinToNormals = sinDifferenceClamped(sinAxis, cosAxis, sinNormals, node.cosNormals);
        cosEmitterBest = cosDifferenceClamped(sinToNormals, cosToNormals, sinSpread, cosSpread);
    }
    if (cosEmitterBest <= node.cosEmission) { return 0.0f; }

    return weight * cosEmitterBest * (kGrazingWeight + (1.0f - kGrazingWeight) * cosReceiverBest);
}

/// A chosen light. probability 0: no light can reach the place.
struct LightChoice {
    uint32_t emitter = 0;
    float probability = 0.0f;
};

// ---- Lights infinitely far away: directional ones and the environment ----

/// An environment behind a portal by about the share of directions that the portal takes.
template <FeatureMask kMask>
GLINT_HD inline float environmentImportance(const LightView& lights, const LightContext& at) {
    if constexpr (hasFeature<kMask>(kFeaturePortal)) {
        const EmitterData& opening = lights.portal.opening;
        if (opening.area > 0.0f) {
            const Vec3 d = at.p - opening.position;
            if (!(glm::dot(d, opening.direction) > 0.0f)) { return 0.0f; }
            return lights.environmentIrradiance * minf(1.0f, opening.area / (kPi * lengthSquared(d)));
        }
    }
    return lights.environmentIrradiance;
}

template <FeatureMask kMask>
GLINT_HD inline float infiniteImportance(const LightView& lights, const EmitterData& e,
                                         const LightContext& at) {
    if (e.kind == EmitterKind::Environment) { return environmentImportance<kMask>(lights, at); }
    const float cosine = -glm::dot(at.n, e.direction);
    return e.area *
           (at.bothSides ? std::fabs(cosine) : maxf(cosine, 0.0f));  // area: the irradiance's luminance
}

template <FeatureMask kMask>
GLINT_HD inline float infiniteImportanceSum(const LightView& lights, const LightContext& at) {
    float sum = 0.0f;
    for (uint32_t i = lights.finiteCount; i < lights.emitters.count; ++i) {
        sum += infiniteImportance<kMask>(lights, lights.emitters[i], at);
    }
    return sum;
}

/// `u` in [0, 1) is used up.
template <FeatureMask kMask>
GLINT_HD inline LightChoice chooseInfinite(const LightView& lights, const LightContext& at, float sum,
                                           float u) {
    LightChoice choice;
    float left = u * sum;
    for (uint32_t i = lights.finiteCount; i < lights.emitters.count; ++i) {
        const float importance = infiniteImportance<kMask>(lights, lights.emitters[i], at);
        if (importance <= 0.0f) { continue; }
        choice = {i, importance / sum};
        if (left < importance) { break; }
        left -= importance;
    }
    return choice;
}

// ---- Few lights with a place ----

/// Returns the sum, and each light's own.
GLINT_HD inline float weighFew(const LightView& lights, const LightContext& at, float (&each)[kFewLights]) {
    float sum = 0.0f;
    for (uint32_t i = 0; i < lights.finiteCount; ++i) {
        each[i] = lightImportance(lights.nodes[i], at);
        sum += each[i];
    }
    return sum;
}

GLINT_HD inline LightChoice chooseAmongFew(const LightView& lights, const float (&each)[kFewLights],
                                           float sum, float u) {
    if (lights.finiteCount == 1) { return {0, 1.0f}; }
    LightChoice choice;
    float left = u * sum;
    for (uint32_t i = 0; i < lights.finiteCount; ++i) {
        const float importance = each[i];
        if (importance <= 0.0f) { continue; }
        choice = {i, importance / sum};
        if (left < importance) { break; }
        left -= importance;
    }
    return choice;
}

// ---- Many lights: the tree ----

/// From the root down, at each node choosing a child by importance and stretching what is left of `u` to
/// [0, 1).
GLINT_HD inline LightChoice chooseInTree(const LightView& lights, const LightContext& at, float u) {
    float probability = 1.0f;
    uint32_t index = 0;
    while (!lights.nodes[index].isLeaf) {
        const uint32_t child = lights.nodes[index].child;
        const float first = lightImportance(lights.nodes[child], at);
        const float second = lightImportance(lights.nodes[child + 1], at);
        if (!(first + second > 0.0f)) { return {}; }
        const float share = first / (first + second);
        if (u < share) {
            index = child;
            probability *= share;
            u = minf(u / share, kOneMinusEpsilon);
        } else {
            index = child + 1;
            probability *= 1.0f - share;
            u = minf((u - share) / (1.0f - share), kOneMinusEpsilon);
        }
    }
    return {lights.nodes[index].child, probability};
}

GLINT_HD inline float treeProbability(const LightView& lights, const LightContext& at, uint32_t emitter) {
    float probability = 1.0f;
    uint32_t index = lights.emitterNodes[emitter];
    while (index != 0) {
        const uint32_t parent = lights.nodes[index].parent;
        const uint32_t child = lights.nodes[parent].child;
        const float first = lightImportance(lights.nodes[child], at);
        const float second = lightImportance(lights.nodes[child + 1], at);
        if (!(first + second > 0.0f)) { return 0.0f; }
        const float share = first / (first + second);
        probability *= index == child ? share : 1.0f - share;
        index = parent;
    }
    return probability;
}

// ---- Together ----

/// Probability of turning to the lights with a place: their share of the importance, but at least a tenth for
/// either kind, because the bounds know nothing of shadows. Certain where the other kind cannot contribute.
GLINT_HD inline float finiteShare(float finite, float infinite) {
    if (infinite <= 0.0f) { return 1.0f; }
    if (finite <= 0.0f) { return 0.0f; }
    return clampf(finite / (finite + infinite), 0.1f, 0.9f);
}

template <FeatureMask kMask>
GLINT_HD inline bool usesLightTree(const LightView& lights) {
    return hasFeature<kMask>(kFeatureManyLights) && lights.usesTree;
}

/// The importance of the lights with a place together: a tree's as its root's, else the sum of `each`.
template <FeatureMask kMask>
GLINT_HD inline float weighFinite(const LightView& lights, const LightContext& at,
                                  float (&each)[kFewLights]) {
    if (lights.finiteCount == 0) { return 0.0f; }
    if (usesLightTree<kMask>(lights)) { return lightImportance(lights.nodes[0], at); }
    return weighFew(lights, at, each);
}

/// Chooses one of all lights for a place; `u` in [0, 1).
template <FeatureMask kMask>
GLINT_HD inline LightChoice chooseLight(const LightView& lights, const LightContext& at, float u) {
    if (lights.emitters.count <= 1) { return {0, lights.emitters.count == 1 ? 1.0f : 0.0f}; }
    float each[kFewLights];
    const float finite = weighFinite<kMask>(lights, at, each);
    const float infinite = infiniteImportanceSum<kMask>(lights, at);
    if (!(finite + infinite > 0.0f)) { return {}; }
    const float share = finiteShare(finite, infinite);
    LightChoice choice;
    if (u < share) {
        choice = usesLightTree<kMask>(lights) ? chooseInTree(lights, at, u / share)
                                              : chooseAmongFew(lights, each, finite, u / share);
        choice.probability *= share;
    } else {
        choice = chooseInfinite<kMask>(lights, at, infinite, (u - share) / (1.0f - share));
        choice.probability *= 1.0f - share;
    }
    return choice;
}

/// Probability with which chooseLight() chooses `emitter` for a place.
template <FeatureMask kMask>
GLINT_HD inline float lightProbability(const LightView& lights, const LightContext& at, uint32_t emitter) {
    if (lights.emitters.count == 1) { return 1.0f; }
    float each[kFewLights];
    const float finite = weighFinite<kMask>(lights, at, each);
    const float infinite = infiniteImportanceSum<kMask>(lights, at);
    if (!(finite + infinite > 0.0f)) { return 0.0f; }
    const float share = finiteShare(finite, infinite);
    if (emitter >= lights.finiteCount) {
        if (share >= 1.0f) { return 0.0f; }
        return (1.0f - share) * infiniteImportance<kMask>(lights, lights.emitters[emitter], at) / infinite;
    }
    if (share <= 0.0f) { return 0.0f; }
    if (usesLightTree<kMask>(lights)) { return share * treeProbability(lights, at, emitter); }
    if (lights.finiteCount == 1) { return share; }
    return share * each[emitter] / finite;
}

}  // namespace glint

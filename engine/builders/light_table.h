// All lights of a scene as flat arrays: emitters, how they are chosen, and the environment's distribution.
//
// It is made anew whenever emission, a transform of an emissive object, a light or the
// environment changed. Knows nothing of sampling itself (kernels/light_sampling.h).
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/builders/environment_table.h"
#include "engine/builders/portal_table.h"
#include "engine/builders/texture_table.h"
#include "engine/kernels/features.h"
#include "engine/kernels/light_view.h"
#include "engine/scene/scene.h"

namespace glint {

struct LightTable {
    std::vector<EmitterData> emitters;
    std::vector<LightNode> nodes;
    std::vector<uint32_t> emitterNodes;
    /// For each object the index of its first emitter, or kNone: not emissive, or an infinite plane, which
    /// shines but cannot be sampled. Instances take it into InstanceData::firstEmitter.
    std::vector<uint32_t> firstEmitter;
    std::shared_ptr<const EnvironmentTable> environment;  ///< null without an environment image
    EmitterData portal;                                   ///< PortalView::opening
    std::shared_ptr<const PortalSums> portalSums;         ///< null without a portal, or without an image
    uint32_t finiteCount = 0;
    bool usesTree = false;
    bool environmentIsSeenOnly = false;
    std::vector<EmitterData> castLights;
    float environmentIrradiance = 0.0f;
    Vec3 environmentRadiance{0.0f};
    float environmentRotationRad = 0.0f;

    /// The light bits of the feature mask: area, delta and many lights, the kinds of environment, its portal.
    FeatureMask features() const;
    /// Host pointers into this object.
    LightView view() const;
    size_t bytes() const;

    bool operator==(const LightTable&) const = default;
};

/// `previous` (may be null) lends its environment distribution when the image is the same object, and is
/// returned itself where nothing changed.
/// Deterministic for any number of threads (0: all). The description must be valid: indices in range,
/// transforms invertible.
std::shared_ptr<const LightTable> buildLightTable(const SceneDescription& scene, const TextureTable& textures,
                                                  const std::shared_ptr<const LightTable>& previous,
                                                  int threads);

}  // namespace glint

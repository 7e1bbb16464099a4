// Lights without a shape as emitters, and the bounds by which lights are chosen. For light_table.
#pragma once

#include "engine/builders/texture_table.h"
#include "engine/kernels/light_view.h"
#include "engine/scene/light.h"

namespace glint {

/// A light that is a point or a direction. The description must be valid.
EmitterData pointlikeEmitter(const Light& light, const TextureTable& textures);

/// Where, which way and how strongly a single light with a place shines.
LightNode leafNode(const EmitterData& emitter);

}  // namespace glint

// What a panel says while a texture or an environment image that was left on the disk is being read, and why
// it could not be.
#pragma once

#include "viewer/model/asset_reader.h"

namespace glint {

void drawAssetState(AssetReader* assets);

}  // namespace glint

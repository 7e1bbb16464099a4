#include "viewer/panels/asset_state.h"

#include "viewer/ui/error_box.h"
#include "viewer/ui/widgets.h"

namespace glint {

void drawAssetState(AssetReader* assets) {
    if (assets->reading()) {
        ui::hint("Reading its file…");
    } else if (assets->error() && drawErrorBox("Its file cannot be used", *assets->error())) {
        assets->dismissError();
    }
}

}  // namespace glint

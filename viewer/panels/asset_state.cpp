// What the window says while a texture or an environment image that was left on the disk is being read.
#include "viewer/panels/error_box.h"
#include "viewer/panels/panels.h"
#include "viewer/window/widgets.h"

namespace glint {

void drawAssetState(ViewerModel* model) {
    if (model->readingAssets()) {
        ui::hint("Reading its file…");
    } else if (model->assetError() && drawErrorBox("Its file cannot be used", *model->assetError())) {
        model->dismissAssetError();
    }
}

}  // namespace glint

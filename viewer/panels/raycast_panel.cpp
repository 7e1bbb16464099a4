// Ray casting's settings: edits of them restart its film and nothing else. Shown while it is.
#include "viewer/model/display_settings.h"
#include "viewer/model/scene_document.h"
#include "viewer/panels/panel.h"
#include "viewer/ui/widgets.h"

namespace glint {
namespace {

void draw(SceneDocument* document) {
    RayCastOptions* options = &document->draft().rayCast;
    ui::toggle("Shadows", &options->shadows, "Whether lights without a shape cast shadows");
    ui::toggle("Falloff", &options->falloff,
               "Whether point and spot lights fall off with distance, or shine everywhere as at the scene's "
               "middle");
    ui::color("Ambient", &options->ambient, 1e6f, "Light from all around, which nothing shades");
}

bool isShown(const SceneDocument* document, const DisplaySettings* display) {
    return display->shows(IntegratorKind::RayCast, document->draft().options.integrator);
}

}  // namespace

Panel raycastPanel() {
    return {"Ray casting",
            true,
            OfParts<draw>::call,
            WithoutScene::Hides,
            "Phong's model under the lights without a shape (Phong 1975)",
            OfParts<isShown>::call};
}

}  // namespace glint

// The panels, top to bottom. Each draws one section and changes the model's draft or settings; none knows
// what restarts.
//
// Called once a frame by viewer/window/app. One file per panel.
#pragma once

#include "viewer/window/viewer_model.h"

namespace glint {

void drawScenePanel(ViewerModel* model);
void drawRenderPanel(ViewerModel* model);
void drawConvergencePanel(ViewerModel* model);
void drawSppmPanel(ViewerModel* model);
void drawCameraPanel(ViewerModel* model);
void drawMaterialsPanel(ViewerModel* model);
void drawLightsPanel(ViewerModel* model);
void drawDisplayPanel(ViewerModel* model);
void drawImagePanel(ViewerModel* model);
void drawCheckpointPanel(ViewerModel* model);
void drawLogPanel();

/// That a file is being read which the draft uses, or why it could not be; part of other panels.
void drawAssetState(ViewerModel* model);

/// All of them.
void drawPanels(ViewerModel* model);

}  // namespace glint

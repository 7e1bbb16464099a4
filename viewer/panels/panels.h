// The column of panels.
#pragma once

namespace glint {

class Workspace;

/// Draws all of them, top to bottom. They change drafts and settings, and none knows what restarts.
void drawPanels(Workspace* workspace);

}  // namespace glint

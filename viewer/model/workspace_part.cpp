#include "viewer/model/workspace_part.h"

#include <tuple>

#include "viewer/model/workspace.h"

namespace glint {

template <class Part>
Part* partOf(Workspace* w) {
    return &std::get<Part&>(std::tie(w->notice, w->document, w->history, w->render, w->display, w->lens,
                                     w->inspector, w->region, w->gizmo, w->outliner, w->library, w->bookmarks,
                                     w->sceneFiles, w->filmFiles, w->assets, w->convergence, w->curveExport,
                                     w->faults, w->snapshots, w->keys, w->frames, w->ocio, w->presets));
}

template Notice* partOf(Workspace*);
template SceneDocument* partOf(Workspace*);
template EditHistory* partOf(Workspace*);
template RenderControl* partOf(Workspace*);
template DisplaySettings* partOf(Workspace*);
template LensSettings* partOf(Workspace*);
template Inspector* partOf(Workspace*);
template RegionTool* partOf(Workspace*);
template GizmoSettings* partOf(Workspace*);
template Outliner* partOf(Workspace*);
template CameraBookmarks* partOf(Workspace*);
template MaterialLibrary* partOf(Workspace*);
template SceneFiles* partOf(Workspace*);
template FilmFiles* partOf(Workspace*);
template AssetReader* partOf(Workspace*);
template ConvergenceWatch* partOf(Workspace*);
template CurveExport* partOf(Workspace*);
template FaultFinder* partOf(Workspace*);
template Snapshots* partOf(Workspace*);
template KeyMap* partOf(Workspace*);
template FrameSeries* partOf(Workspace*);
template OcioChooser* partOf(Workspace*);
template PresetImages* partOf(Workspace*);

}  // namespace glint

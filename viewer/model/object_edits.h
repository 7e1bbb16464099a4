// Objects and lights that are added, copied, hidden and removed. All of it is an edit of the
// document's draft.
#pragma once

#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "viewer/model/material_presets.h"
#include "viewer/model/scene_document.h"

namespace glint {

/// The shapes that need no more than a place.
std::vector<ShapeKind> addableShapes();

/// What is added stands at the camera's target, is so large that it takes a fifth of the picture's height,
/// has the material that is selected, and is selected then.
void addShape(SceneDocument* document, ShapeKind kind);
void addBox(SceneDocument* document);
/// Above the camera's target.
void addLight(SceneDocument* document);

/// All of these need a selected object, and do nothing without one.
void duplicateSelection(SceneDocument* document);
void deleteSelection(SceneDocument* document);
/// It is out of the picture until it is shown: among SceneDescription::hiddenObjects.
void hideSelection(SceneDocument* document);
/// Hides all others but those that shine.
void soloSelection(SceneDocument* document);
void showAll(SceneDocument* document);
/// Brings back one of SceneDescription::hiddenObjects, as the last object, selected; nothing without it.
void showHidden(SceneDocument* document, size_t index);

/// Gives an object of the draft the material, and selects both; a preset becomes one of the scene's, or is it
/// already, under its name or, where another material has that, the name with a number. Nothing where there
/// is no such object or material.
void giveMaterial(SceneDocument* document, int object, const MaterialDrag& given);

/// Adds the objects, meshes, materials and textures of another scene to `scene`, so large and there that they
/// stand at `place`, `size` metres wide. Lights, camera and environment stay the scene's own. Returns the
/// number of objects.
size_t addScene(const SceneDescription& other, const Vec3& place, float size, SceneDescription* scene);

}  // namespace glint

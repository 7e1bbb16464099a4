// Small scenes for tests of photon mapping.
#pragma once

#include "engine/scene/scene.h"

namespace glint::test {

/// The scene at 32x32 pixels with at most eight scattering events.
SceneDescription small(SceneDescription scene);

/// A box of diffuse walls with a lamp, and a ball of rough glass in it; small.
SceneDescription roughGlassBox();

/// Balls of rough glass that rest on a floor, one with a shell of it inside, beside a sheet of two tiles of
/// it that lies on the floor: everywhere surfaces that photons pass, closer to what is behind than a
/// radius; small.
SceneDescription roughGlassInContact();

/// A box whose floor has steep waves by heights and whose ball's normals lean by a map; small.
SceneDescription bumpyBox();

/// A box with a veil of opacity 0.4 across it and a ball with holes; small.
SceneDescription cutoutBox();

/// The box with a ball of rough glass that absorbs, and a clear one inside it; small.
SceneDescription absorbingGlassBox();

/// A box with a sheet across it that light passes diffusely, and a ball of the same; small.
SceneDescription translucentBox();
/// A painted ball with a smooth coat, one of cloth, and a sheet of worn metal whose inputs are textures.
SceneDescription principledBox();
/// The box with a body and a sheet that let light pass in part, and scatter the rest; small.
SceneDescription passingBox();
/// The box with a wall of Phong's model and a sheet of Ward's; small.
SceneDescription highlightBox();
/// A box with two sheets of brushed metal. They are flat: on the balls, six pixels wide, normals turn within
/// a disc by as much as the facets do.
SceneDescription brushedBox();
/// The same under coats that absorb.
SceneDescription coatedBox();

/// The box without its balls, lit by a projector instead of its lamp: a point, whose shadows and edges would
/// be hard, so that its picture fades and there are none; small.
SceneDescription projectorBox();

/// The same, lit from its middle by a goniometric light.
SceneDescription goniometricBox();

/// The box without its balls and its lamp, lit by an uneven sky through a portal over a hole in its ceiling,
/// with a black disc outside that hides a part of the sky; small. The open front lets nothing in.
SceneDescription portalBox();

/// A ball and a cube of glass of extreme dispersion on a floor, one seen through the other: what a camera
/// path and a photon are bent by meets on the floor, and in a second ball of rough glass; small.
SceneDescription dispersiveGlass();

/// The same scene with the other side of each flat opaque object as its front: to be seen alike.
SceneDescription otherWinding(SceneDescription scene);

/// A Cornell box with a glass sphere, so that photons do what paths cannot.
SceneDescription glassBox();

/// Every surface of a closed room white and many scatterings: photons are kept at many more places than there
/// are photons.
SceneDescription whiteRoom();

}  // namespace glint::test

// The editable scene. Belongs to whoever edits it (the UI thread, a command); knows nothing of rendering.
//
// Heavy parts (triangles, pixels) are immutable and shared, so that a copy is cheap: an edit copies the
// description, changes the copy and posts it together with what changed (scene_edit.h).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/base/kinds.h"
#include "engine/math/transform.h"
#include "engine/scene/camera.h"
#include "engine/scene/image.h"
#include "engine/scene/light.h"
#include "engine/scene/material.h"
#include "engine/scene/mesh_data.h"
#include "engine/scene/reading_options.h"
#include "engine/scene/render_options.h"

namespace glint {

/// A placed shape. Several objects may share one mesh (instances).
struct Object {
    std::string name;
    ShapeKind shape = ShapeKind::Sphere;
    int mesh = -1;                        ///< ShapeKind::Mesh: index into SceneDescription::meshes
    CurveKind curve = CurveKind::Bezier;  ///< ShapeKind::Revolved: of `profile`
    int curveDegree = 0;        ///< Revolved, of Bézier curves: up to 15; 0: one curve of all points
    std::vector<Vec2> profile;  ///< Revolved: control points (distance from the y axis, height)
    bool capped = false;        ///< Revolved: discs close it where the profile ends off the axis
    /// Revolved: rays meet what one clamped search finds (a known bug, to see it)
    bool clampsSearch = false;
    int material = 0;        ///< index into SceneDescription::materials
    Affine objectToWorld;    ///< must be invertible
    bool frontOnly = false;  ///< rays meet it only from the side the geometric normal points to
};

/// An image used as a colour or a number.
struct Texture {
    std::string name;
    SceneImage image;
    ColorEncoding encoding = ColorEncoding::Srgb;
    bool flipV = false;        ///< v counted from the image's top row
    Vec2 scale{1.0f};          ///< uv is multiplied by this,
    float rotationDeg = 0.0f;  ///< then turned counter-clockwise about (0, 0),
    Vec2 offset{0.0f};         ///< then moved
    WrapMode wrapU = WrapMode::Repeat, wrapV = WrapMode::Repeat;  ///< beyond [0, 1]
    TexelFilter filter = TexelFilter::Bilinear;
    TextureChannel channel = TextureChannel::Red;     ///< where a single number is asked for
    float base = 0.0f, gain = 1.0f, exponent = 1.0f;  ///< (base + gain x)^exponent is shown for x

    /// Whether it needs more than a scale, repetition, and mixtures of the texels' own values.
    bool isPlaced() const {
        return rotationDeg != 0.0f || offset != Vec2(0.0f) || wrapU != WrapMode::Repeat ||
               wrapV != WrapMode::Repeat || filter == TexelFilter::Nearest ||
               channel != TextureChannel::Red || base != 0.0f || gain != 1.0f || exponent != 1.0f;
    }
};

struct SceneDescription {
    std::string path;         ///< the file it came from; relative paths inside are relative to its folder
    ReadingOptions readWith;  ///< by the loader: how that file was read
    std::string title;        ///< what the scene shows, one line
    std::string description;  ///< more about it: what to look at, or which value it must have
    Camera camera;
    Resolution resolution;
    RenderOptions options;
    SppmOptions sppm;
    RayCastOptions rayCast;
    std::vector<Texture> textures;
    std::vector<SceneImage> environmentImages;
    std::vector<Material> materials;  ///< never empty when there are objects
    std::vector<Mesh> meshes;
    std::vector<Object> objects;
    /// Kept in the scene and in its files, and no part of what is rendered; drawn again once it is among
    /// `objects`. Nothing reads or builds what these alone use.
    std::vector<Object> hiddenObjects;
    std::vector<Light> lights;
    Environment environment;
    std::vector<std::string> warnings;   ///< what the loader had to guess, repair or leave out, for the log
    std::vector<std::string> notes;      ///< what it decided where the file is sound, but leaves it open
    std::vector<std::string> filesRead;  ///< by the loader: the scene's own and all that it needed
};

}  // namespace glint

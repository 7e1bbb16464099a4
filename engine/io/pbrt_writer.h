// Text of pbrt-v4 scenes. Internal to the pbrt exporter (export_pbrt.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/scene/scene.h"

namespace glint {

/// Parameters behind a directive, a blank before each. Floats are written with the fewest digits that give
/// the same float back.
std::string pbrtNumber(std::string_view name, float value);
std::string pbrtInteger(std::string_view name, int value);
std::string pbrtFlag(std::string_view name, bool value);
std::string pbrtString(std::string_view name, std::string_view value);
std::string pbrtRgb(std::string_view name, const Vec3& value);
std::string pbrtPoint(std::string_view name, const Vec3& value);
std::string pbrtPoints(std::string_view name, const std::vector<Vec3>& values);
/// In quotes.
std::string pbrtQuoted(std::string_view text);

/// Writes a Texture directive for an image that materials have as a colour or as a number; where pbrt shows
/// it differently, that is appended to `warnings` once.
std::string pbrtTexture(const SceneDescription& scene, int index, bool isNumber,
                        std::vector<std::string>* warnings);
/// What pbrtTexture() calls it.
std::string pbrtTextureName(int index, bool isNumber);
/// A colour or a number, which may be a texture.
std::string pbrtColorInput(std::string_view name, const ColorInput& input);
std::string pbrtNumberInput(std::string_view name, const NumberInput& input);

/// The material as a MakeNamedMaterial directive.
std::string pbrtMaterial(const SceneDescription& scene, int index, std::vector<std::string>* warnings);
std::string pbrtMaterialName(const SceneDescription& scene, int index);

/// What a projector without a colour sends out by its picture, and a goniometric light by its image, as
/// pbrt's images of such lights have it, upright. The one is an intensity, for which the other's irradiance
/// at a distance of 1 is divided by the cube of the cosine, in 1024 columns or more; the other is grey, which
/// warns where it was not, and has its own texels where they are not interpolated.
ImageF pbrtProjectedImage(const SceneDescription& scene, const Light& light);
ImageF pbrtGoniometricImage(const SceneDescription& scene, const Light& light,
                            std::vector<std::string>* warnings);
/// Either light, with that image file.
std::string pbrtImageLight(const Light& light, std::string_view file);

/// Integrator, film and camera, up to WorldBegin.
std::string pbrtView(const SceneDescription& scene, std::vector<std::string>* warnings);

}  // namespace glint

// Text of Mitsuba XML, and what its parts share. Internal to the Mitsuba exporter (export_mitsuba.cpp).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/mitsuba_textures.h"
#include "engine/scene/scene.h"

namespace glint {

/// Floats are written with the fewest digits that give the same float back.
class MitsubaWriter {
  public:
    /// `attributes` as they stand in the text: `type="sphere"`.
    void open(std::string_view tag, std::string_view attributes);
    void close();
    void element(std::string_view tag, std::string_view attributes);

    void number(std::string_view name, float value);
    void integer(std::string_view name, int value);
    void flag(std::string_view name, bool value);
    void string(std::string_view name, std::string_view value);
    void color(std::string_view name, const Vec3& value);
    void matrix(std::string_view name, const Affine& value);

    const std::string& text() const { return text_; }

  private:
    std::string text_;
    std::vector<std::string> open_;
};

/// Escaped for attributes, and `$` so that it begins no parameter.
std::string xmlText(std::string_view text);
std::string xmlNumbers(const Vec3& v);

/// How a material is used: its bsdf differs with each of these.
struct MitsubaUse {
    int material = 0;
    UvOrigin origin = UvOrigin::Bottom;
    bool isOneSided = false;
    bool hasColors = false;

    auto operator<=>(const MitsubaUse&) const = default;
    std::string id(const SceneDescription& scene) const;
};

/// Writes the integrator, the sensor and its film.
void writeMitsubaView(const SceneDescription& scene, MitsubaWriter* out, std::vector<std::string>* warnings);
/// Writes the bsdf of a use; what it leaves out is appended to `warnings`, each once.
void writeMitsubaMaterial(const SceneDescription& scene, const MitsubaUse& use, MitsubaWriter* out,
                          std::vector<std::string>* warnings);
/// A texture as the property `name` of what is open.
void writeMitsubaTexture(const Texture& texture, UvOrigin origin, bool isNumber, std::string_view name,
                         MitsubaWriter* out, std::vector<std::string>* warnings);

}  // namespace glint

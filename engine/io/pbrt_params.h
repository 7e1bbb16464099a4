// The parameters of a pbrt directive, `"type name" value`, asked for by name. Internal to the pbrt importer.
//
// What nobody has asked for is remarked on: nothing is dropped silently.
#pragma once

#include <initializer_list>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/pbrt_context.h"

namespace glint {

enum class PbrtType : uint8_t { Float, Integer, Bool, String, Texture, Rgb, Xyz, Spectrum, Blackbody };

struct PbrtParam {
    std::string name;
    PbrtType type = PbrtType::Float;
    PbrtPlace place;
    std::vector<float> numbers;      ///< Float (points and vectors, too), Rgb, Xyz, Spectrum, Blackbody
    std::vector<int> integers;       ///< Integer
    std::vector<std::string> texts;  ///< String, Texture, Spectrum by name or file; Bool: true, false
    bool isDefault = false;          ///< from an Attribute directive
    mutable bool isUsed = false;
};

class PbrtParams {
  public:
    PbrtParams() = default;
    PbrtParams(PbrtContext* context, PbrtPlace place, PbrtColorSpace space)
        : context_(context), place_(place), space_(space) {}

    void add(PbrtParam param) { params_.push_back(std::move(param)); }
    /// Values for names that are not there.
    void addDefaults(const PbrtParams& defaults);
    /// Whether there are more than 64, or one has more than 64 values.
    bool isLong() const;
    /// For messages: the directive and its name.
    void setOwner(std::string directive, std::string name) {
        directive_ = std::move(directive);
        name_ = std::move(name);
    }

    PbrtContext& context() const { return *context_; }
    const PbrtPlace& place() const { return place_; }
    PbrtColorSpace colorSpace() const { return space_; }
    bool has(std::string_view name) const { return find(name) != nullptr; }
    /// Null: there is none. It then counts as asked for.
    const PbrtParam* find(std::string_view name) const;

    /// Values; `otherwise` where there is none. Fails where one has another type. Numbers are clamped to
    /// [least, most].
    float number(std::string_view name, float otherwise, float least = -1e18f, float most = 1e18f) const;
    int integer(std::string_view name, int otherwise, int least, int most) const;
    bool flag(std::string_view name, bool otherwise) const;
    std::string text(std::string_view name, std::string_view otherwise = {}) const;
    Vec3 point(std::string_view name, const Vec3& otherwise) const;
    /// All numbers of a name; empty: there is none. Fails unless they are a multiple of `group`.
    const std::vector<float>& numbers(std::string_view name, size_t group) const;
    const std::vector<int>& integers(std::string_view name, size_t group) const;
    /// The same as points. Fails where one is above 1e18.
    std::vector<Vec3> points(std::string_view name) const;

    /// Parameters that change no picture, or nothing here.
    void passOver(std::initializer_list<std::string_view> names) const;
    /// A warning that is told once: "approximated: …".
    void approximated(std::string_view sentence) const { context_->remark(place_, sentence, name_); }
    void fail(std::string message) const { context_->fail(place_, std::move(message)); }
    /// Remarks on what nobody has asked for.
    void finish() const;

  private:
    const PbrtParam* ofType(std::string_view name, PbrtType type, size_t count) const;

    PbrtContext* context_ = nullptr;
    PbrtPlace place_;
    PbrtColorSpace space_ = PbrtColorSpace::Srgb;
    std::string directive_, name_;
    std::vector<PbrtParam> params_;
};

/// Reads what follows in the text: as many parameters as there are. Fails in the context.
PbrtParams readPbrtParams(PbrtContext* context, PbrtText* text, const PbrtPlace& place, PbrtColorSpace space);

}  // namespace glint

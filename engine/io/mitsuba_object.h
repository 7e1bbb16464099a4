// What a Mitsuba element with a type holds, asked for by name. Internal to the Mitsuba importer.
//
// The first error is kept in the context, and what is asked for afterwards has usable values: readers ask for
// it once at the end. What nobody has asked for is remarked on: nothing is dropped silently.
#pragma once

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/import_context.h"
#include "engine/io/mitsuba_xml.h"

namespace glint {

/// What all parts of the importer share.
class MitsubaContext : public ImportContext<MitsubaElement> {
  public:
    MitsubaContext(const MitsubaXml& scenesXml, const LoadOptions& loadOptions)
        : ImportContext(loadOptions), xml(scenesXml) {}

    std::string findFile(const MitsubaElement& at, std::string_view name) const override {
        return xml.findFile(at, name);
    }

    const MitsubaXml& xml;
    int nesting = 0;  ///< objects within each other, references followed

  private:
    Error errorAt(const MitsubaElement& at, std::string message) const override {
        return xml.error(at, std::move(message));
    }
    std::string placeOf(const MitsubaElement& at) const override { return xml.placeOf(at); }
};

/// The words of a list that blanks and commas part.
std::vector<std::string_view> mitsubaWords(std::string_view list);
/// Fails, and gives 0, where the word is no finite number.
double mitsubaNumber(MitsubaContext* context, const MitsubaElement& at, std::string_view word);
/// All words as numbers. Fails unless there are as many as one of `counts`; an empty list of them: any.
std::vector<double> mitsubaNumbers(MitsubaContext* context, const MitsubaElement& at, std::string_view list,
                                   std::initializer_list<size_t> counts);
/// The attribute "value" of one or three numbers, or "x", "y" and "z", each `otherwise` where it is missing.
Vec3 mitsubaVector(MitsubaContext* context, const MitsubaElement& at, float otherwise);
/// A <transform>: what stands first is applied first. Fails unless it is affine and finite.
Affine mitsubaTransform(MitsubaContext* context, const MitsubaElement& transform);

class MitsubaObject {
  public:
    /// `element`: no reference. Fails where objects refer to each other more than 64 deep.
    MitsubaObject(MitsubaContext* context, const MitsubaElement& element);
    ~MitsubaObject() { --context_->nesting; }
    MitsubaObject(const MitsubaObject&) = delete;
    MitsubaObject& operator=(const MitsubaObject&) = delete;

    const MitsubaElement& element() const { return element_; }
    MitsubaContext& context() const { return *context_; }
    std::string_view type() const { return element_.attribute("type"); }

    /// The property or nested object of that name; null: none.
    const MitsubaElement* property(std::string_view name);
    /// The next nested object with one of these tags that nobody has asked for; null: no more.
    const MitsubaElement* next(std::initializer_list<std::string_view> tags);

    /// Values of properties; `otherwise` where there is none. Numbers are clamped to [least, most].
    float number(std::string_view name, float otherwise, float least = -1e18f, float most = 1e18f);
    int integer(std::string_view name, int otherwise, int least, int most);
    bool flag(std::string_view name, bool otherwise);
    std::string_view text(std::string_view name, std::string_view otherwise = {});
    Vec3 vector(std::string_view name, const Vec3& otherwise);
    Affine transform(std::string_view name = "to_world");

    /// Properties that change no picture, or nothing here.
    void passOver(std::initializer_list<std::string_view> names);
    /// A warning that is told once: "approximated: …".
    void approximated(std::string_view sentence) { context_->remark(element_, sentence, nameForMessages()); }
    /// Remarks on what nobody has asked for.
    void finish();

  private:
    const MitsubaElement* resolved(size_t child);
    std::string_view nameForMessages() const;

    MitsubaContext* context_;
    const MitsubaElement& element_;
    std::vector<bool> used_;
};

}  // namespace glint

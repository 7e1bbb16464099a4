// A Mitsuba scene's XML with its includes and parameters in place: elements, their attributes, and where they
// stand. Internal to the Mitsuba importer (mitsuba_*.cpp).
//
// Names are those of version 3: `toWorld` is read as `to_world`, `lookAt` as `lookat`, `luminaire` as
// `emitter`, `camera` as `sensor`. Nothing here knows what elements mean.
#pragma once

#include <deque>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/load_options.h"

namespace glint {

struct MitsubaAttribute {
    std::string_view name, value;
};

/// Texts live as long as the MitsubaXml.
struct MitsubaElement {
    std::string_view tag;
    std::vector<MitsubaAttribute> attributes;
    std::vector<MitsubaElement> children;
    uint32_t file = 0;  ///< the number of the file that it stands in
    size_t offset = 0;  ///< where in its text

    bool has(std::string_view name) const;
    /// Empty where it has no such attribute.
    std::string_view attribute(std::string_view name) const;
};

class MitsubaXml {
  public:
    /// Reads the file and what it includes. Error, with its place: not readable, no XML, declared entities, a
    /// root other than <scene>, a parameter without a value, an include that leads back to itself or cannot
    /// be read, more than 100 levels, 4 million elements, or 256 MiB of replaced parameters.
    static Result<std::unique_ptr<MitsubaXml>> read(const std::string& path,
                                                    const SceneParameters& parameters);
    ~MitsubaXml();
    MitsubaXml(const MitsubaXml&) = delete;
    MitsubaXml& operator=(const MitsubaXml&) = delete;

    const MitsubaElement& root() const { return root_; }
    /// 0 for 0.4 to 0.6, else the first number of the scene's version.
    int majorVersion() const { return majorVersion_; }
    /// Null: none has that id.
    const MitsubaElement* find(std::string_view id) const;
    /// Parameters that were given and that the scene does not have.
    std::vector<std::string> unusedParameters() const;

    Error error(const MitsubaElement& at, std::string message) const;
    /// "file:line", for remarks.
    std::string placeOf(const MitsubaElement& at) const;
    /// A file that `at` names, looked for in the folders of <path>, of the scene and of its own file; the
    /// name as seen from the scene's folder where it is nowhere.
    std::string findFile(const MitsubaElement& at, std::string_view name) const;

  private:
    struct File;
    struct Parameter {
        std::string value;
        bool isGiven = false, isUsed = false;
    };
    friend class MitsubaXmlReader;

    MitsubaXml() = default;
    SourcePlace placeIn(const File& file, size_t offset) const;
    void collectIds(const MitsubaElement& element);

    std::vector<std::unique_ptr<File>> files_;
    std::deque<std::string> replaced_;  ///< values with parameters replaced
    std::map<std::string, Parameter, std::less<>> parameters_;
    std::map<std::string_view, const MitsubaElement*> ids_;
    std::vector<std::string> folders_;
    MitsubaElement root_;
    int majorVersion_ = 3;
};

}  // namespace glint

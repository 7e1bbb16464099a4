// The directives of a pbrt scene one after the other, with what it includes in its place. Internal to the
// pbrt importer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/io/pbrt_params.h"

namespace glint {

struct PbrtDirective {
    std::string_view name;  ///< lives as long as the program
    PbrtPlace place;
    std::vector<double> numbers;
    std::vector<std::string> texts;
    PbrtParams params;
};

class PbrtParser {
  public:
    explicit PbrtParser(PbrtContext* context) : context_(*context) {}

    /// Begins with the scene's own file. Fails in the context.
    void open(const std::string& path);
    /// The next directive; false at the scene's end and after an error. What an Import names stands between
    /// AttributeBegin and AttributeEnd, and what pbrt does not have is remarked on and passed over.
    bool next(PbrtDirective* out);
    /// What `rgb` values mean from here on.
    void setColorSpace(PbrtColorSpace space) { space_ = space; }

  private:
    struct Open {
        uint32_t file;
        std::string key;
        bool isImport;
        PbrtPlace from;
    };

    bool openFile(const std::string& path, const PbrtPlace& from, bool isImport);
    bool close(PbrtDirective* out);
    bool include(const PbrtDirective& directive);
    bool readArguments(PbrtText* text, PbrtDirective* out);
    void passUnknown(PbrtText* text, const PbrtPlace& at, std::string_view word);

    PbrtContext& context_;
    PbrtColorSpace space_ = PbrtColorSpace::Srgb;
    std::vector<Open> open_;
    size_t bytes_ = 0;
};

}  // namespace glint

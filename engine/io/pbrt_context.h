// What all parts of the pbrt importer share: the scene, its files, what is said about it. Internal to the
// pbrt importer.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "engine/io/file_path.h"
#include "engine/io/import_context.h"
#include "engine/io/pbrt_text.h"

namespace glint {

/// A named space of `rgb` values.
enum class PbrtColorSpace : uint8_t { Srgb, Rec2020, Aces2065, DciP3 };

struct PbrtFile {
    PbrtFile(std::string name, std::string bytes, uint32_t number)
        : path(std::move(name)), text(std::move(bytes), number) {}

    std::string path;
    PbrtText text;
};

class PbrtContext : public ImportContext<PbrtPlace> {
  public:
    using ImportContext::ImportContext;

    /// Beside the scene's own file, or else beside the one that names it.
    std::string findFile(const PbrtPlace& at, std::string_view name) const override {
        return findBeside(name, files[0].path, files[at.file].path);
    }

    std::deque<PbrtFile> files;
    std::vector<std::string> meshWarnings;

  private:
    Error errorAt(const PbrtPlace& at, std::string message) const override;
    std::string placeOf(const PbrtPlace& at) const override;
};

}  // namespace glint

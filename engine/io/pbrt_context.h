// What all parts of the pbrt importer share: the scene, its files, what is said about it. Internal to the
// pbrt importer.
//
// The first error is kept here, and what is asked for afterwards has usable values.
#pragma once

#include <deque>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/io/load_options.h"
#include "engine/io/pbrt_text.h"
#include "engine/io/remarks.h"
#include "engine/scene/scene.h"

namespace glint {

/// A named space of `rgb` values.
enum class PbrtColorSpace : uint8_t { Srgb, Rec2020, Aces2065, DciP3 };

struct PbrtFile {
    PbrtFile(std::string name, std::string bytes, uint32_t number)
        : path(std::move(name)), text(std::move(bytes), number) {}

    std::string path;
    PbrtText text;
};

struct PbrtContext {
    const LoadOptions& options;
    SceneDescription scene = {};
    Affine world = {};  ///< where the whole scene is placed: mirrored where its camera is left-handed
    std::deque<PbrtFile> files = {};
    Remarks remarks = {};
    Remarks notes = {};
    std::optional<Error> error = {};
    std::set<std::string, std::less<>> sentences = {};
    std::vector<std::string> meshWarnings = {};

    bool failed() const { return error.has_value(); }
    void fail(const PbrtPlace& at, std::string message);
    /// `kind` is a sentence that lives as long as the program; one that is made here is kept by sentence().
    void remark(const PbrtPlace& at, std::string_view kind, std::string_view detail = {});
    void note(const PbrtPlace& at, std::string_view kind, std::string_view detail = {});
    /// An error, or with LoadOptions::allowMissing a remark.
    void refuse(const PbrtPlace& at, std::string message);
    std::string_view sentence(std::string text);
    /// A file that the scene names: beside the scene's own file, or else beside the one that names it.
    std::string findFile(const PbrtPlace& at, std::string_view name) const;
    /// The same as seen from the scene's folder.
    std::string fileOf(const PbrtPlace& at, std::string_view name) const;

  private:
    std::string placeOf(const PbrtPlace& at) const;
};

}  // namespace glint

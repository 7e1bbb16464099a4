// What all parts of an importer share: the scene, what is said about it, and the first error. For formats
// whose readers go on after an error with usable values, and are asked for it once at the end.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "engine/base/result.h"
#include "engine/io/file_path.h"
#include "engine/io/load_options.h"
#include "engine/io/remarks.h"
#include "engine/scene/scene.h"

namespace glint {

/// `Place`: where something stands in the importer's files.
template <class Place>
class ImportContext {
  public:
    explicit ImportContext(const LoadOptions& loadOptions) : options(loadOptions) {}
    ImportContext(const ImportContext&) = delete;
    ImportContext& operator=(const ImportContext&) = delete;
    virtual ~ImportContext() = default;

    /// Where the file is that `name` names, as it can be opened.
    virtual std::string findFile(const Place& at, std::string_view name) const = 0;
    /// The same as seen from the scene's folder.
    std::string fileOf(const Place& at, std::string_view name) const {
        return seenFromFolder(findFile(at, name), name, scene.path);
    }

    bool failed() const { return error.has_value(); }
    void fail(const Place& at, std::string message) {
        if (!error) { error = errorAt(at, std::move(message)); }
    }
    /// `kind` is a sentence that lives as long as the program; one that is made here is kept by sentence().
    void remark(const Place& at, std::string_view kind, std::string_view detail = {}) {
        remarks.add(
            kind, [&] { return placeOf(at); }, detail);
    }
    void note(const Place& at, std::string_view kind, std::string_view detail = {}) {
        notes.add(
            kind, [&] { return placeOf(at); }, detail);
    }
    /// An error, or with LoadOptions::allowMissing a remark.
    void refuse(const Place& at, std::string message) {
        if (options.allowMissing) {
            remark(at, sentence(std::move(message)));
        } else {
            fail(at, message + "; --allow-missing goes on without it");
        }
    }
    std::string_view sentence(std::string text) {
        constexpr size_t kMost = 40;
        if (const auto found = sentences_.find(text); found != sentences_.end()) { return *found; }
        if (sentences_.size() >= kMost) { return "more is left out that Glint does not have"; }
        return *sentences_.insert(std::move(text)).first;
    }

    const LoadOptions& options;
    SceneDescription scene;
    Affine world;  ///< where the whole scene is placed: mirrored where the file's camera mirrors
    Remarks remarks, notes;
    std::optional<Error> error;

  private:
    virtual Error errorAt(const Place& at, std::string message) const = 0;
    /// "file:line".
    virtual std::string placeOf(const Place& at) const = 0;

    std::set<std::string, std::less<>> sentences_;
};

}  // namespace glint

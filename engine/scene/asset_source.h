// Where an image or a mesh comes from, so that it can be read when something uses it, and saved by its name.
#pragma once

#include <compare>
#include <memory>
#include <string>
#include <variant>

namespace glint {

/// A file on the disk.
struct FileSource {
    std::string path;  ///< as written in the scene file
    int part = -1;  ///< meshes: the n-th part (OBJ: a run of one material), in file order; -1: the whole file
    bool isFaceted = false;  ///< meshes: triangles without normals stay flat; else they get smooth ones

    auto operator<=>(const FileSource&) const = default;
};

/// A whole image or mesh file in memory, which stood inside another file. Two are equal when they share
/// their bytes.
struct EmbeddedFile {
    std::string name;  ///< in messages, and what a save calls the file that it writes beside the scene
    std::shared_ptr<const std::string> bytes;  ///< never null

    auto operator<=>(const EmbeddedFile&) const = default;
};

/// The first alternative stands for data that is the scene's own: triangles written in the scene file, pixels
/// made in code. It cannot be read again.
template <class... Generators>
using AssetSource = std::variant<std::monostate, FileSource, EmbeddedFile, Generators...>;

/// The path of a file as written in the scene; empty for all other sources.
template <class... Generators>
std::string pathOf(const AssetSource<Generators...>& source) {
    const auto* file = std::get_if<FileSource>(&source);
    return file != nullptr ? file->path : std::string();
}

}  // namespace glint

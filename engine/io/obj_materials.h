// From the material names of an OBJ file to Glint materials and textures.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"
#include "engine/io/mtl_loader.h"
#include "engine/io/named_files.h"
#include "engine/io/remarks.h"

namespace glint {

/// Gives parts their materials: reads the libraries, then takes over what parts use. What was missing or
/// guessed goes into the file's warnings and notes by finish().
class MaterialResolver {
  public:
    MaterialResolver(const std::string& objPath, MeshFile* file) : objPath_(objPath), file_(*file) {}

    /// `lines` are what mtllib lines name. A missing or unreadable file is a warning.
    void readLibraries(const std::vector<std::string>& lines);
    /// Whether one of them has a material of this name, or of a like one.
    bool defines(const std::string& material) const;
    /// For the materials of all parts, so that they are not held twice while they become more.
    void makeRoom();
    int indexOf(const MeshPart& part);
    /// Gives bumps their height in metres, once all parts have their materials.
    void scaleBumps();
    void finish();

  private:
    /// Index of a library, and of its entry.
    struct Found {
        size_t library;
        size_t entry;
    };

    void readLibrary(const std::string& path);
    const Found* findMaterial(const MeshPart& part);
    Material take(const Found& found);
    int takeTexture(const MtlMap& map, const std::string& library);

    const std::string& objPath_;
    MeshFile& file_;
    NamedFiles files_;
    Remarks remarks_;
    std::vector<MtlLibrary> libraries_;
    std::map<std::string, Found, std::less<>> found_;
    std::map<std::string, std::string, std::less<>> looseNames_;  ///< in small letters, to names in found_
    std::map<std::string, int, std::less<>> taken_;
    std::map<std::string, int, std::less<>> textures_;  ///< by path and how they are shown
    std::map<bool, int> unknown_;                       ///< one for many, for parts with colours and others
    size_t unknownCount_ = 0;
    std::vector<std::string> glass_, opaque_;  ///< name and why, for the notes
};

}  // namespace glint

// From the material names of an OBJ file to Glint materials and textures. Called by obj_loader.cpp only.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"
#include "engine/io/mtl_loader.h"

namespace glint {

/// Gives parts their materials: reads the libraries, then takes over what parts use.
class MaterialResolver {
  public:
    MaterialResolver(const std::string& objPath, MeshFile* file) : objPath_(objPath), file_(*file) {}

    /// `lines` are what mtllib lines name. A missing file is a warning, a malformed one an error.
    Status readLibraries(const std::vector<std::string>& lines);
    /// `name` is what usemtl says, empty for none; `place` is `file:line` of it.
    int indexOf(const std::string& name, const std::string& place);

  private:
    struct Found {
        MtlMaterial mtl;
        std::string library;
    };

    Status readLibrary(const std::string& name);
    void takeTexture(const Found& found, Material* material);
    void warnMissing(const std::string& name, const std::string& place);

    const std::string& objPath_;
    MeshFile& file_;
    std::map<std::string, Found, std::less<>> found_;
    std::map<std::string, int, std::less<>> taken_;
    std::map<std::string, int, std::less<>> textures_;  ///< by path and scale
};

}  // namespace glint

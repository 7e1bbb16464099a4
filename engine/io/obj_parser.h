// One pass over the text of an OBJ file. Materials are looked up at the end, so that `usemtl` may come before
// its `mtllib`. For obj_loader.cpp only.
//
// What is repaired and what is refused stands in engine/io/README.md.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/io/mesh_file.h"
#include "engine/io/obj_part_builder.h"
#include "engine/io/text_cursor.h"

namespace glint {

class ObjParser {
  public:
    /// `verticesFirst`: the text is gone through for v, vt and vn before all else, so that faces may name
    /// what comes later.
    ObjParser(const std::string& text, const std::string& path, bool verticesFirst)
        : cursor_(text, path), builder_(pools_), verticesFirst_(verticesFirst) {}

    Status run();
    /// After run(): it has failed because a face names what comes later, or never.
    bool needsVerticesFirst() const { return needsVerticesFirst_; }
    const TextCursor& cursor() const { return cursor_; }
    const ObjPartBuilder& builder() const { return builder_; }

    MeshFile file;  ///< all but materials and textures

  private:
    enum Attribute : size_t { kPosition, kUv, kNormal, kAttributes };

    bool runLines(bool (ObjParser::*parse)(std::string_view, const char*));
    bool parseAttribute(std::string_view keyword, const char* where);
    bool parseStatement(std::string_view keyword, const char* where);
    bool parseUnknown(std::string_view keyword, const char* where);
    bool readPosition(Vec3* p);
    bool failAtVertex(int32_t index);
    bool parsePosition();
    bool parseUv();
    bool parseNormal();
    bool parseFace(const char* where);
    bool recoverFace(const char* where);
    void keepFirstOddFace(const Error& error);
    bool addFace(const char* where);
    bool parseCorner(ObjCorner* corner);
    bool parseOptionalIndex(const char** at, const char* end, Attribute attribute, int32_t* index);
    bool parseIndex(const char** at, const char* end, Attribute attribute, int32_t* index);
    bool leaveOutIndex(const char** at, const char* end, Attribute attribute);
    bool resolveIndex(int64_t number, std::string_view word, Attribute attribute, int32_t* index);
    bool countLine(Attribute attribute);
    void leaveOutRest(const char* where);
    void readPolypaint();
    void useMaterial(const char* where);
    void useSmoothing();
    void finishPart();
    Error noFaces();

    TextCursor cursor_;
    ObjPools pools_;
    ObjPartBuilder builder_;
    bool verticesFirst_;
    bool needsVerticesFirst_ = false;
    std::array<size_t, kAttributes> known_{};    ///< in the pools
    std::array<size_t, kAttributes> defined_{};  ///< up to the present line
    size_t painted_ = 0;                         ///< vertices that have polypaint
    std::vector<ObjCorner> corners_;
    std::vector<SmoothingRun> smoothing_;   ///< of the present part
    Smoothing group_ = Smoothing::ByAngle;  ///< in force now
    std::string name_;                      ///< group or object in force now
    std::string partName_;                  ///< at the part's first face
    std::string materialName_;              ///< in force now
    int materialLine_ = 0;
    const char* firstOdd_ = nullptr;  ///< the first line that no OBJ file has
    /// vertices without a position, in rising order, and where their numbers stand
    std::vector<std::pair<size_t, const char*>> unplaced_;
    bool failedAtNumber_ = false;        ///< a corner names a vertex that is not there
    std::optional<Error> firstOddFace_;  ///< of a face that was left out though it has corners
};

}  // namespace glint

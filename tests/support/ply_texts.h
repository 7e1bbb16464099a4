// Texts of PLY files that tests put together, and what comes out of them.
#pragma once

#include <string>

#include <gtest/gtest.h>

#include "engine/io/ply_loader.h"

namespace glint::test {

inline const std::string kXyz = "property float x\nproperty float y\nproperty float z\n";
inline const std::string kList = "property list uchar int vertex_indices\n";
inline const std::string kHead = "ply\nformat ascii 1.0\nelement vertex 4\n" + kXyz;
inline const std::string kCorners = "-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";

inline MeshFile parse(const std::string& text) {
    auto file = parsePly(text, "in.ply");
    EXPECT_TRUE(file) << file.error().format() << "\n" << text;
    return file ? std::move(*file) : MeshFile{};
}

inline Vec3 areaOf(const MeshFile& file) {
    Vec3 area(0.0f);
    for (const MeshPart& part : file.parts) {
        const MeshData& mesh = *part.mesh;
        for (size_t i = 0; i < mesh.indices.size(); i += 3) {
            const Vec3& a = mesh.positions[mesh.indices[i]];
            area += 0.5f * glm::cross(mesh.positions[mesh.indices[i + 1]] - a,
                                      mesh.positions[mesh.indices[i + 2]] - a);
        }
    }
    return area;
}

/// With another word in all its places.
inline std::string withWord(std::string text, const std::string& word, const std::string& other) {
    for (size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + other.size())) {
        text.replace(at, word.size(), other);
    }
    return text;
}

}  // namespace glint::test

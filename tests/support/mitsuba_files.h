// Small serialized meshes of Mitsuba for tests.
#pragma once

#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <zlib.h>

#include "tests/support/gltf_files.h"

namespace glint::test {

/// A file of serialized meshes as Mitsuba's manual describes it.
inline std::string serializedFile(uint16_t version, const std::vector<std::string>& meshes) {
    std::string out;
    std::vector<uint64_t> begins;
    for (const std::string& mesh : meshes) {
        begins.push_back(out.size());
        out += packed<uint16_t>({0x041c, version});
        std::string packedMesh(compressBound(mesh.size()), '\0');
        uLongf size = packedMesh.size();
        EXPECT_EQ(compress(reinterpret_cast<Bytef*>(packedMesh.data()), &size,
                           reinterpret_cast<const Bytef*>(mesh.data()), mesh.size()),
                  Z_OK);
        out += packedMesh.substr(0, size);
    }
    for (const uint64_t begin : begins) {
        out += version == 4 ? packed<uint64_t>({begin}) : packed<uint32_t>({static_cast<uint32_t>(begin)});
    }
    return out + packed<uint32_t>({static_cast<uint32_t>(meshes.size())});
}

template <class Number>
std::string serializedTriangle(uint32_t flags, const std::string& name, float size) {
    const auto s = static_cast<Number>(size);
    return packed<uint32_t>({flags}) + name + packed<uint64_t>({3, 1}) +
           packed<Number>({0, 0, 0, s, 0, 0, 0, s, 0}) + packed<Number>({0, 0, 1, 0, 0, 1, 0, 0, 1}) +
           packed<Number>({0, 0, 1, 0, 0, 1}) + packed<uint32_t>({0, 1, 2});
}

}  // namespace glint::test

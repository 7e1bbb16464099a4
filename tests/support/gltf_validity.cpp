#include "tests/support/gltf_validity.h"

#include <cmath>
#include <cstring>
#include <set>

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include "engine/io/atomic_file.h"
#include "engine/math/vec.h"

namespace glint::test {
namespace {

bool keepAsIs(tinygltf::Image*, int, std::string*, std::string*, int, int, const unsigned char*, int, void*) {
    return true;
}

class Validator {
  public:
    explicit Validator(const tinygltf::Model& model) : model_(model) {}

    void check() {
        EXPECT_EQ(model_.asset.version, "2.0");
        for (const auto& view : model_.bufferViews) {
            EXPECT_EQ(view.byteOffset % 4, 0u);
            EXPECT_LE(view.byteOffset + view.byteLength, model_.buffers.at(at(view.buffer)).data.size());
        }
        for (const auto& accessor : model_.accessors) {
            EXPECT_GT(accessor.count, 0u);
            EXPECT_LE(accessor.byteOffset + accessor.count * sizeOf(accessor),
                      model_.bufferViews.at(at(accessor.bufferView)).byteLength);
        }
        for (const auto& mesh : model_.meshes) {
            EXPECT_FALSE(mesh.primitives.empty());
            for (const auto& primitive : mesh.primitives) {
                checkPrimitive(primitive);
            }
        }
        for (const auto& node : model_.nodes) {
            checkMatrix(node.matrix);
        }
        const std::set<std::string> used(model_.extensionsUsed.begin(), model_.extensionsUsed.end());
        EXPECT_EQ(used.size(), model_.extensionsUsed.size()) << "each once";
        for (const auto& material : model_.materials) {
            for (const auto& [name, members] : material.extensions) {
                EXPECT_TRUE(used.contains(name)) << name;
            }
        }
    }

  private:
    static size_t at(int index) { return index < 0 ? SIZE_MAX : static_cast<size_t>(index); }
    static size_t sizeOf(const tinygltf::Accessor& accessor) {
        return static_cast<size_t>(
            tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(accessor.componentType)) *
            tinygltf::GetNumComponentsInType(static_cast<uint32_t>(accessor.type)));
    }
    template <class Value>
    std::vector<Value> values(const tinygltf::Accessor& accessor) const {
        const auto& view = model_.bufferViews.at(at(accessor.bufferView));
        const auto& bytes = model_.buffers.at(at(view.buffer)).data;
        std::vector<Value> out(accessor.count);
        EXPECT_EQ(sizeOf(accessor), sizeof(Value));
        std::memcpy(out.data(), bytes.data() + view.byteOffset + accessor.byteOffset,
                    out.size() * sizeof(Value));
        return out;
    }

    void checkPrimitive(const tinygltf::Primitive& primitive) const {
        const auto& positions = model_.accessors.at(at(primitive.attributes.at("POSITION")));
        Vec3 least(INFINITY), most(-INFINITY);
        const std::vector<Vec3> places = values<Vec3>(positions);
        for (const Vec3& p : places) {
            least = glm::min(least, p);
            most = glm::max(most, p);
        }
        for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(static_cast<float>(positions.minValues.at(at(c))), least[c]);
            EXPECT_EQ(static_cast<float>(positions.maxValues.at(at(c))), most[c]);
        }
        for (const auto& [name, accessor] : primitive.attributes) {
            EXPECT_EQ(model_.accessors.at(at(accessor)).count, positions.count) << name;
        }
        if (const auto normals = primitive.attributes.find("NORMAL"); normals != primitive.attributes.end()) {
            for (const Vec3& normal : values<Vec3>(model_.accessors.at(at(normals->second)))) {
                EXPECT_NEAR(glm::length(normal), 1.0f, 2e-3f);
            }
        }
        if (const auto tangents = primitive.attributes.find("TANGENT");
            tangents != primitive.attributes.end()) {
            EXPECT_TRUE(primitive.attributes.contains("NORMAL"));
            for (const Vec4& tangent : values<Vec4>(model_.accessors.at(at(tangents->second)))) {
                EXPECT_NEAR(glm::length(Vec3(tangent)), 1.0f, 2e-3f);
                EXPECT_EQ(std::fabs(tangent.w), 1.0f);
            }
        }
        const auto& indices = model_.accessors.at(at(primitive.indices));
        EXPECT_EQ(indices.count % 3, 0u);
        const std::vector<uint32_t> corners = values<uint32_t>(indices);
        for (size_t i = 0; i < corners.size(); ++i) {
            ASSERT_LT(corners[i], positions.count);
            const uint32_t next = corners[i % 3 < 2 ? i + 1 : i - 2];
            ASSERT_NE(places[corners[i]], places.at(next)) << "a triangle without area";
        }
        EXPECT_LT(at(primitive.material), model_.materials.size());
    }

    /// Rotations and scales along the axes alone.
    static void checkMatrix(const std::vector<double>& m) {
        for (size_t a = 0; a < 3 && !m.empty(); ++a) {
            double dot = 0.0, u = 0.0, v = 0.0;
            for (size_t c = 0; c < 3; ++c) {
                const double x = m.at(4 * a + c), y = m.at(4 * ((a + 1) % 3) + c);
                dot += x * y;
                u += x * x;
                v += y * y;
            }
            EXPECT_LE(std::abs(dot), 2e-4 * std::sqrt(u * v));
            EXPECT_EQ(m.at(4 * a + 3), 0.0);
        }
    }

    const tinygltf::Model& model_;
};

}  // namespace

void expectValidGltf(const std::string& path) {
    tinygltf::TinyGLTF parser;
    parser.SetImageLoader(keepAsIs, nullptr);
    tinygltf::Model model;
    std::string errors, warnings;
    const bool isBinary = path.ends_with(".glb");
    EXPECT_TRUE(isBinary ? parser.LoadBinaryFromFile(&model, &errors, &warnings, path)
                         : parser.LoadASCIIFromFile(&model, &errors, &warnings, path));
    EXPECT_EQ(errors, "");
    EXPECT_EQ(warnings, "");
    Validator(model).check();
}

}  // namespace glint::test

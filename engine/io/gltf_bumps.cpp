// Height maps as the normal maps that glTF has instead.
#include <algorithm>
#include <cmath>

#include "engine/io/gltf_export.h"
#include "engine/io/scene_export.h"
#include "engine/scene/scene_use.h"

namespace glint {
namespace {

/// Metres along u and v, on the average of the area.
class MeanTangents {
  public:
    void add(const MeshData& mesh, const Affine& toWorld) {
        if (mesh.uvs.empty()) { return; }
        for (size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            const uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
            const Vec2 p = mesh.uvs[b] - mesh.uvs[a], q = mesh.uvs[c] - mesh.uvs[a];
            const Vec3 d = toWorld.vector(mesh.positions[b] - mesh.positions[a]);
            const Vec3 e = toWorld.vector(mesh.positions[c] - mesh.positions[a]);
            const float determinant = p.x * q.y - p.y * q.x;
            if (determinant == 0.0f) { continue; }
            const float area = glm::length(glm::cross(d, e));
            along_ += glm::dvec2(area * glm::length((q.y * d - p.y * e) / determinant),
                                 area * glm::length((p.x * e - q.x * d) / determinant));
            area_ += static_cast<double>(area);
        }
    }
    Vec2 mean() const { return area_ > 0.0 ? Vec2(along_ / area_) : Vec2(1.0f); }

  private:
    glm::dvec2 along_{0.0};
    double area_ = 0.0;
};

/// What one repetition of the texture's image is wide and high on the objects of a material, in metres.
Vec2 imageSizeOn(const SceneDescription& scene, int material, const Texture& texture) {
    constexpr int kMostObjects = 64;  // they tell enough
    MeanTangents tangents;
    int count = 0;
    for (const Object& object : scene.objects) {
        if (object.material != material || count++ == kMostObjects) { continue; }
        const bool isMesh = object.shape == ShapeKind::Mesh;
        const auto data = isMesh ? scene.meshes[static_cast<size_t>(object.mesh)].data : nullptr;
        tangents.add(data ? *data : shapeMesh(object), object.objectToWorld);
    }
    const Vec2 per = tangents.mean() / glm::abs(texture.scale);
    const float angle = texture.rotationDeg * (kPi / 180.0f), c = std::cos(angle), s = std::sin(angle);
    return {std::hypot(c * per.x, s * per.y), std::hypot(s * per.x, c * per.y)};
}

int wrapped(int i, int size, WrapMode wrap) {
    return wrap == WrapMode::Repeat ? (i + size) % size : std::clamp(i, 0, size - 1);
}

/// The normals of heights of `bumpHeight` metres, whose image is of that size.
Image8 normalsOf(const Texture& heights, float bumpHeight, const Vec2& sizeMetres) {
    const SceneImage& from = heights.image;
    const int width = from.bytes ? from.bytes->width : from.floats->width;
    const int height = from.bytes ? from.bytes->height : from.floats->height;
    const Vec2 steep = bumpHeight * Vec2(width, height) / (2.0f * sizeMetres);
    const auto at = [&](int x, int y) {
        x = wrapped(x, width, heights.wrapU);
        y = wrapped(y, height, heights.wrapV);
        return shownNumber(heights,
                           static_cast<size_t>(y) * static_cast<size_t>(width) + static_cast<size_t>(x));
    };
    Image8 normals{width, height, {}, {}};
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec3 normal(-steep.x * (at(x + 1, y) - at(x - 1, y)),
                              -steep.y * (at(x, y - 1) - at(x, y + 1)), 1.0f);
            const Vec3 code = 127.5f * glm::normalize(normal) + Vec3(127.5f);
            for (int c = 0; c < 3; ++c) {
                normals.rgb.push_back(static_cast<uint8_t>(std::lround(code[c])));
            }
        }
    }
    return normals;
}

}  // namespace

bool makeBumpsNormals(SceneDescription* scene) {
    bool hadBumps = false;
    const std::vector<bool> used = usedMaterials(*scene);
    for (size_t i = 0; i < used.size(); ++i) {
        Material& material = scene->materials[i];
        if (!used[i] || material.bump.texture < 0 || material.normalMap.texture >= 0) { continue; }
        const Texture& heights = scene->textures[static_cast<size_t>(material.bump.texture)];
        if (!heights.image.isRead()) { continue; }
        Texture normals = heights;
        normals.image = {};
        normals.image.bytes = std::make_shared<const Image8>(
            normalsOf(heights, material.bumpHeight, imageSizeOn(*scene, static_cast<int>(i), heights)));
        normals.encoding = ColorEncoding::Linear;
        normals.base = 0.0f;
        normals.gain = normals.exponent = 1.0f;
        material.normalMap.texture = static_cast<int>(scene->textures.size());
        material.normalStrength = 1.0f;
        material.bump.texture = -1;
        scene->textures.push_back(std::move(normals));
        hadBumps = true;
    }
    return hadBumps;
}

}  // namespace glint

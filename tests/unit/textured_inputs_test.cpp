// Textures on inputs of materials other than the colour: what a model computes with at a point, what the
// builders make of them, and what of them is used at all.
#include <gtest/gtest.h>

#include "engine/builders/coat_albedo.h"
#include "engine/builders/feature_scan.h"
#include "engine/builders/material_table.h"
#include "engine/io/used_assets.h"
#include "engine/kernels/bsdf/bsdf.h"
#include "engine/kernels/scene_view.h"
#include "engine/scene/scene_use.h"
#include "tests/support/uniform_numbers.h"

namespace glint::test {
namespace {

/// Two texels side by side; bytes where both fit. Read at their centres, they come back as they are.
Texture twoTexels(const Vec3& left, const Vec3& right) {
    auto image = std::make_shared<ImageF>();
    image->width = 2;
    image->height = 1;
    image->rgb = {left.x, left.y, left.z, right.x, right.y, right.z};
    Texture texture;
    texture.name = "two texels";
    texture.image.floats = image;
    return texture;
}

struct Point {
    Vec3 ng{0.0f, 0.0f, 1.0f};
    Vec3 ns{0.0f, 0.0f, 1.0f};
    Vec2 uv{0.0f};
    Vec3 vertexColor{1.0f};
    Vec3 dpdu{1.0f, 0.0f, 0.0f};
    Vec3 dpdv{0.0f, 1.0f, 0.0f};
    uint32_t material = 0;
};

const Vec2 kLeft(0.25f, 0.5f), kRight(0.75f, 0.5f);

/// A sphere of one material, built.
class Subject {
  public:
    explicit Subject(const Material& material, std::vector<Texture> textures = {}) {
        scene_.materials = {material};
        scene_.textures = std::move(textures);
        scene_.objects.resize(1);
        scene_.objects[0].material = 0;
        textures_ = *buildTextureTable(scene_, nullptr);
        const auto built = buildMaterialTable(scene_, *textures_, nullptr);
        EXPECT_TRUE(built) << built.error().message;
        table_ = *built;
        view_.materials = viewOf(table_->materials);
        view_.textures = viewOf(textures_->textures);
        view_.coats = viewOf(table_->coats);
    }

    Bsdf<kAllFeatures> at(const Vec2& uv, const Vec3& wo) const {
        Point point;
        point.uv = uv;
        return makeBsdf<kAllFeatures>(view_, point, wo);
    }
    FeatureMask features() const { return scanFeatures(scene_, *table_); }
    const MaterialTable& table() const { return *table_; }
    const SceneDescription& scene() const { return scene_; }

  private:
    SceneDescription scene_;
    std::shared_ptr<const TextureTable> textures_;
    std::shared_ptr<const MaterialTable> table_;
    SceneView view_;
};

Material materialOf(MaterialKind kind) {
    Material material;
    material.name = "subject";
    material.kind = kind;
    material.color.value = Vec3(0.8f, 0.6f, 0.4f);
    material.metal = "";
    material.specular.value = 0.7f;
    material.clearcoat.value = 0.5f;
    material.sheenColor.value = Vec3(0.3f);
    return material;
}

/// `relative` is what plastic's interpolated table may add.
void expectSame(const Bsdf<kAllFeatures>& a, const Bsdf<kAllFeatures>& b, UniformNumbers* random,
                float relative) {
    EXPECT_EQ(isSpecularOnly(a), isSpecularOnly(b));
    const auto near = [&](float x, float y) { return std::fabs(x - y) <= relative * std::fabs(y); };
    for (int i = 0; i < 50; ++i) {
        const float uLobe = random->next();
        const Vec2 u = random->next2();
        const BsdfSample x = sample(a, uLobe, u);
        const BsdfSample y = sample(b, uLobe, u);
        ASSERT_EQ(x.valid, y.valid);
        EXPECT_EQ(x.isSpecular, y.isSpecular);
        EXPECT_EQ(x.wi, y.wi);
        EXPECT_TRUE(near(x.pdfSolidAngle, y.pdfSolidAngle)) << x.pdfSolidAngle << " " << y.pdfSolidAngle;
        const Vec3 there = evaluate(a, x.wi);
        const Vec3 here = evaluate(b, x.wi);
        for (int c = 0; c < 3; ++c) {
            EXPECT_TRUE(near(x.weight[c], y.weight[c])) << x.weight[c] << " " << y.weight[c];
            EXPECT_TRUE(near(there[c], here[c])) << there[c] << " " << here[c];
        }
    }
}

struct InputCase {
    const char* name;
    MaterialKind kind;
    Vec3 left, right;
    /// The texture index of the input, and its constant set.
    int* (*texture)(Material*);
    void (*set)(Material*, const Vec3&);
    float relative = 0.0f;
};

class TexturedInputs : public testing::TestWithParam<InputCase> {};

TEST_P(TexturedInputs, AreTheConstantsThatTheTextureHolds) {
    const InputCase& param = GetParam();
    for (const float roughness : {0.0f, 0.2f}) {
        Material material = materialOf(param.kind);
        material.roughness.value = roughness;
        Material left = material, right = material;
        param.set(&left, param.left);
        param.set(&right, param.right);
        *param.texture(&material) = 0;
        const Subject textured(material, {twoTexels(param.left, param.right)});
        const Subject constantLeft(left), constantRight(right);
        EXPECT_EQ(textured.features() & (kFeatureTextures | kFeatureInputTextures),
                  kFeatureTextures | kFeatureInputTextures);
        EXPECT_EQ(constantLeft.features() & (kFeatureTextures | kFeatureInputTextures), FeatureMask{0});
        UniformNumbers random(3);
        for (int i = 0; i < 20; ++i) {
            const Vec3 wo = sampleSphere(random.next2());
            SCOPED_TRACE(testing::Message() << "roughness " << roughness << ", wo.z " << wo.z);
            expectSame(textured.at(kLeft, wo), constantLeft.at(kLeft, wo), &random, param.relative);
            expectSame(textured.at(kRight, wo), constantRight.at(kRight, wo), &random, param.relative);
        }
    }
}

void setValue(float* value, const Vec3& v) { *value = v.x; }
void setValue(Vec3* value, const Vec3& v) { *value = v; }

/// Of the input that a pointer to a member of MaterialInputs names.
template <auto kInput>
InputCase inputCase(const char* name, MaterialKind kind, const Vec3& left, const Vec3& right) {
    return {name,
            kind,
            left,
            right,
            [](Material* m) { return &(m->*kInput).texture; },
            [](Material* m, const Vec3& v) { setValue(&(m->*kInput).value, v); }};
}

INSTANTIATE_TEST_SUITE_P(
    All, TexturedInputs,
    testing::Values(
        inputCase<&Material::roughness>("MetalRoughness", MaterialKind::Conductor, Vec3(0.0f), Vec3(0.4f)),
        inputCase<&Material::roughness>("GlassRoughness", MaterialKind::Dielectric, Vec3(0.3f), Vec3(0.0f)),
        inputCase<&Material::ior>("GlassIor", MaterialKind::Dielectric, Vec3(1.0f), Vec3(2.0f)),
        inputCase<&Material::ior>("MixtureIor", MaterialKind::Mixture, Vec3(0.7f), Vec3(2.0f)),
        inputCase<&Material::mixtureWeights>("MixtureWeights", MaterialKind::Mixture, Vec3(0.0f, 3.0f, 1.0f),
                                             Vec3(1.0f, 0.5f, 0.5f)),
        inputCase<&Material::eta>("MetalEta", MaterialKind::Conductor, Vec3(0.2f, 0.9f, 1.1f), Vec3(2.0f)),
        inputCase<&Material::k>("MetalK", MaterialKind::Conductor, Vec3(3.0f, 2.0f, 1.0f), Vec3(7.0f)),
        inputCase<&Material::metallic>("Metallic", MaterialKind::Principled, Vec3(0.0f), Vec3(0.7f)),
        inputCase<&Material::specular>("Specular", MaterialKind::Principled, Vec3(0.0f), Vec3(0.4f)),
        inputCase<&Material::specularTint>("SpecularTint", MaterialKind::Principled, Vec3(0.0f, 0.5f, 1.0f),
                                           Vec3(1.0f)),
        inputCase<&Material::clearcoat>("Clearcoat", MaterialKind::Principled, Vec3(0.0f), Vec3(1.0f)),
        inputCase<&Material::clearcoatRoughness>("ClearcoatRoughness", MaterialKind::Principled, Vec3(0.0f),
                                                 Vec3(0.2f)),
        inputCase<&Material::sheenColor>("SheenColor", MaterialKind::Principled, Vec3(0.0f),
                                         Vec3(1.0f, 0.5f, 0.2f)),
        inputCase<&Material::sheenRoughness>("SheenRoughness", MaterialKind::Principled, Vec3(0.1f),
                                             Vec3(0.9f)),
        inputCase<&Material::specularTransmission>("Transmission", MaterialKind::Principled, Vec3(0.1f),
                                                   Vec3(0.7f)),
        inputCase<&Material::coatAbsorption>("CoatAbsorption", MaterialKind::Coated, Vec3(0.0f),
                                             Vec3(0.3f, 1.5f, 0.1f)),
        inputCase<&Material::ior>("CoatIor", MaterialKind::Coated, Vec3(1.0f), Vec3(2.0f)),
        inputCase<&Material::exponent>("PhongExponent", MaterialKind::Phong, Vec3(0.0f), Vec3(200.0f)),
        inputCase<&Material::specularReflectance>("PhongReflectance", MaterialKind::Phong, Vec3(0.0f),
                                                  Vec3(0.3f, 0.7f, 0.1f)),
        inputCase<&Material::specularReflectance>("WardReflectance", MaterialKind::Ward, Vec3(0.1f),
                                                  Vec3(0.3f, 0.7f, 0.1f)),
        inputCase<&Material::roughness>("WardRoughness", MaterialKind::Ward, Vec3(0.0f), Vec3(0.4f))),
    [](const auto& inputCase) { return std::string(inputCase.param.name); });

/// The coat's albedo at a point of the table is that of a coat made for the point.
TEST(TexturedPlastic, FollowsTheCoatOfThePoint) {
    Material material = materialOf(MaterialKind::Plastic);
    material.roughness.texture = material.ior.texture = 0;
    const Subject both(material, {twoTexels(Vec3(0.5f), Vec3(1.0f))});
    material.ior = {1.5f};
    const Subject roughnessOnly(material, {twoTexels(Vec3(0.5f), Vec3(1.0f))});
    UniformNumbers random(5);
    for (int i = 0; i < 40; ++i) {
        const bool isBoth = i % 2 == 0;
        const Subject& subject = isBoth ? both : roughnessOnly;
        ShadingInputs here;
        here.roughness = square(random.next());
        here.ior = isBoth ? 1.05f + 1.5f * random.next() : 1.5f;
        PlasticModel<kAllFeatures>::settle(subject.table().materials[0], viewOf(subject.table().coats),
                                           &here);
        ShadingInputs exact = here;
        exact.coat = tabulateCoat(here.ior, here.roughness);
        SCOPED_TRACE(testing::Message() << "alpha " << here.roughness << ", index " << here.ior);
        EXPECT_NEAR(here.coat.averageAlbedo, exact.coat.averageAlbedo, 0.003f);
        EXPECT_NEAR(here.coat.internalAlbedo, exact.coat.internalAlbedo, 0.01f);
        for (const float mu : {0.1f, 0.3f, 0.6f, 1.0f}) {
            EXPECT_NEAR(detail::coatAlbedo(here, here.coat, mu), detail::coatAlbedo(exact, exact.coat, mu),
                        0.01f)
                << mu;
        }
    }
}

TEST(TexturedInputLimits, ClampWhatATextureSays) {
    Material material = materialOf(MaterialKind::Dielectric);
    material.roughness.texture = material.ior.texture = 0;
    const Subject subject(material, {twoTexels(Vec3(-3.0f), Vec3(std::nanf("")))});
    for (const Vec2& uv : {kLeft, kRight}) {
        const auto bsdf = subject.at(uv, Vec3(0.0f, 0.0f, 1.0f));
        const ShadingInputs& inputs = bsdf.inputs();
        EXPECT_EQ(inputs.roughness, 0.0f);
        EXPECT_EQ(inputs.ior, 1e-3f);
    }
    Material mixture = materialOf(MaterialKind::Mixture);
    mixture.mixtureWeights.texture = 0;
    const Subject nothing(mixture, {twoTexels(Vec3(0.0f), Vec3(-1.0f))});
    EXPECT_EQ(nothing.at(kLeft, Vec3(0.0f, 0.0f, 1.0f)).inputs().mixtureWeights, Vec3(1.0f, 0.0f, 0.0f));
}

/// Bytes of a number are no colour: 128 is 128 / 255 and not the sRGB curve of it.
TEST(TexturedInputLimits, BytesAreLinear) {
    auto bytes = std::make_shared<Image8>();
    bytes->width = bytes->height = 1;
    bytes->rgb = {128, 0, 0};
    Texture texture;
    texture.image.bytes = bytes;
    texture.encoding = ColorEncoding::Srgb;
    Material material = materialOf(MaterialKind::Conductor);
    material.roughness.texture = 0;
    const Subject subject(material, {texture});
    EXPECT_NEAR(subject.at(kLeft, Vec3(0.0f, 0.0f, 1.0f)).inputs().roughness, 128.0f / 255.0f, 1e-6f);
}

TEST(TexturedInputFeatures, NameWhatATextureMayNeed) {
    Material metal = materialOf(MaterialKind::Conductor);
    metal.roughness.texture = 0;
    const std::vector<Texture> textures{twoTexels(Vec3(0.0f), Vec3(1.0f))};
    EXPECT_EQ(Subject(metal, textures).features(),
              FeatureMask{kFeatureCurved | kFeatureTextures | kFeatureInputTextures | kFeatureGlossy |
                          kFeatureSpecular});
    Material colored = materialOf(MaterialKind::Diffuse);
    colored.color.texture = 0;
    EXPECT_EQ(Subject(colored, textures).features(),
              FeatureMask{kFeatureCurved | kFeatureTextures | kFeatureDiffuse})
        << "colours alone pay nothing";
}

/// What the material's kind does not look at is neither read nor built.
TEST(TexturedInputUse, CountsOnlyWhatTheKindLooksAt) {
    Material material = materialOf(MaterialKind::Diffuse);
    material.roughness.texture = 0;
    EXPECT_TRUE(usedTextures(material).empty());
    const Subject diffuse(material, {Texture{}});
    EXPECT_EQ(diffuse.features(), FeatureMask{kFeatureCurved | kFeatureDiffuse});
    EXPECT_TRUE(lackingAssets(diffuse.scene()).empty());

    SceneDescription scene = diffuse.scene();
    scene.materials[0].kind = MaterialKind::Plastic;
    ASSERT_EQ(lackingAssets(scene).size(), 1u);
    EXPECT_EQ(lackingAssets(scene)[0].kind, AssetKind::Texture);
    EXPECT_TRUE(texturedMeshes(scene).empty());
    goWithout(lackingAssets(scene), &scene);
    EXPECT_EQ(scene.materials[0].roughness.texture, -1);
    EXPECT_TRUE(lackingAssets(scene).empty());

    Material metal = materialOf(MaterialKind::Conductor);
    metal.eta.texture = 0;
    EXPECT_EQ(usedTextures(metal), std::vector<int>{0});
    metal.metal = "gold";
    EXPECT_TRUE(usedTextures(metal).empty()) << "the metal's own constants";
}

}  // namespace
}  // namespace glint::test

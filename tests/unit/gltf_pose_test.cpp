// glTF 2.0: poses of animations against closed forms, and what broken ones leave.
#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/gltf_parts.h"
#include "tests/support/gltf_test.h"

namespace glint {
namespace {

using test::gltf;
using test::kByte;
using test::kFloat;
using test::kShort;
using test::packed;
using test::Parts;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr float kSqrtHalf = std::numbers::sqrt2_v<float> / 2.0f;
constexpr const char* kTriangle = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}])";

/// An animation of one channel for each of `channels`: node, path, times, values, interpolation.
struct Channel {
    int node;
    std::string path;
    int times, values;
    std::string interpolation = "LINEAR";
};
std::string animation(const std::vector<Channel>& channels, const std::string& name = "") {
    std::string of, samplers;
    for (size_t i = 0; i < channels.size(); ++i) {
        const Channel& c = channels[i];
        const std::string comma = i > 0 ? "," : "";
        of += comma + "{\"sampler\": " + std::to_string(i) +
              ", \"target\": {\"node\": " + std::to_string(c.node) + ", \"path\": \"" + c.path + "\"}}";
        samplers += comma + "{\"input\": " + std::to_string(c.times) +
                    ", \"output\": " + std::to_string(c.values) + ", \"interpolation\": \"" +
                    c.interpolation + "\"}";
    }
    return "{\"name\": \"" + name + "\", \"channels\": [" + of + "], \"samplers\": [" + samplers + "]}";
}
std::string animations(const std::string& all) { return "\"animations\": [" + all + "]"; }

class GltfPose : public test::GltfTest {
  protected:
    SceneDescription at(std::optional<float> seconds, const std::string& text) {
        LoadOptions options{.noStudio = true};
        if (seconds) { options.parameters.emplace_back("time", std::to_string(*seconds)); }
        auto scene = loadScene(folder.write("a.gltf", text), options);
        EXPECT_TRUE(scene) << scene.error().format();
        if (!scene) { return {}; }
        EXPECT_TRUE(validateScene(*scene, EditKind::Everything));
        return std::move(*scene);
    }
    /// Where the only object has a point.
    Vec3 pointAt(std::optional<float> seconds, const std::string& text, const Vec3& point = Vec3(0.0f)) {
        const SceneDescription scene = at(seconds, text);
        EXPECT_THAT(scene.warnings, IsEmpty());
        EXPECT_THAT(scene.objects, SizeIs(1));
        return scene.objects.empty() ? Vec3(NAN) : scene.objects[0].objectToWorld.point(point);
    }
    static void expectNear(const Vec3& is, const Vec3& expected, const std::string& what) {
        EXPECT_LT(glm::length(is - expected), 2e-6f * (1.0f + glm::length(expected)))
            << what << ": " << is.x << ' ' << is.y << ' ' << is.z;
    }
};

TEST_F(GltfPose, KeysAreMixedAndHeldAtBothEnds) {
    Parts parts;
    const int times = parts.times({1, 2, 4}), moves = parts.vectors({1, 0, 0, 3, 0, 0, 3, 8, 0}, 3);
    const auto moved = [&](const std::string& how) {
        return gltf(animations(animation({{0, "translation", times, moves, how}})), kTriangle,
                    R"("nodes": [{"mesh": 0, "translation": [9, 9, 9], "scale": [2, 2, 2]}])", parts.text(),
                    parts.buffer);
    };
    const std::string linear = moved("LINEAR"), step = moved("STEP");
    EXPECT_EQ(pointAt({}, linear), Vec3(1, 0, 0)) << "the first frame, not the node's own place";
    EXPECT_EQ(pointAt({}, linear, {1, 0, 0}), Vec3(3, 0, 0)) << "with the node's own scale";
    for (const auto& [seconds, mixed, held] : {std::tuple{0.5f, Vec3(1, 0, 0), Vec3(1, 0, 0)},
                                               {1.0f, Vec3(1, 0, 0), Vec3(1, 0, 0)},
                                               {1.25f, Vec3(1.5f, 0, 0), Vec3(1, 0, 0)},
                                               {2.0f, Vec3(3, 0, 0), Vec3(3, 0, 0)},
                                               {3.5f, Vec3(3, 6, 0), Vec3(3, 0, 0)},
                                               {4.0f, Vec3(3, 8, 0), Vec3(3, 8, 0)},
                                               {77.0f, Vec3(3, 8, 0), Vec3(3, 8, 0)}}) {
        EXPECT_EQ(pointAt(seconds, linear), mixed) << seconds;
        EXPECT_EQ(pointAt(seconds, step), held) << seconds;
    }
}

TEST_F(GltfPose, AStepIsTakenAtItsKeyAsWritten) {
    Parts parts;
    const int times = parts.times({0, 0.1f}), moves = parts.vectors({1, 0, 0, 2, 0, 0}, 3);
    const std::string text = gltf(animations(animation({{0, "translation", times, moves, "STEP"}})),
                                  kTriangle, R"("nodes": [{"mesh": 0}])", parts.text(), parts.buffer);
    EXPECT_EQ(pointAt(0.0999f, text).x, 1.0f);
    EXPECT_EQ(pointAt(0.1f, text).x, 2.0f);
    EXPECT_EQ(pointAt(0.1001f, text).x, 2.0f);
}

/// Of 170 degrees about z a quarter is 42.5, which a mix that is made unit again would miss by 13.
TEST_F(GltfPose, RotationsGoTheShortestWayAtOneSpeed) {
    constexpr double kTurn = 170.0 * std::numbers::pi / 180.0;
    const auto s = static_cast<float>(std::sin(kTurn / 2)), c = static_cast<float>(std::cos(kTurn / 2));
    for (const float sign : {1.0f, -1.0f}) {
        Parts parts;
        const int times = parts.times({0, 2}),
                  turns = parts.vectors({0, 0, 0, 1, 0, 0, sign * s, sign * c}, 4);
        const std::string text =
            gltf(animations(animation({{0, "rotation", times, turns}})), kTriangle,
                 R"("nodes": [{"mesh": 0, "rotation": [1, 0, 0, 0]}])", parts.text(), parts.buffer);
        for (const float seconds : {0.0f, 0.5f, 1.0f, 2.0f}) {
            const double angle = kTurn * static_cast<double>(seconds) / 2;
            expectNear(pointAt(seconds, text, {1, 0, 0}), Vec3(std::cos(angle), std::sin(angle), 0),
                       std::to_string(seconds));
        }
    }
}

TEST_F(GltfPose, NormalisedIntegersAreNumbersUpToOne) {
    Parts parts;
    const int times = parts.times({0, 1});
    // From none to 180 degrees about z: a right angle half-way.
    const int turns = parts.add(packed<int16_t>({0, 0, 0, 32767, 0, 0, 32767, 0}), kShort, "VEC4", 2, true);
    const std::string text = gltf(animations(animation({{0, "rotation", times, turns}})), kTriangle,
                                  R"("nodes": [{"mesh": 0}])", parts.text(), parts.buffer);
    expectNear(pointAt(0.5f, text, {1, 0, 0}), {0, 1, 0}, "half-way");
    expectNear(pointAt(0.25f, text, {1, 0, 0}), {kSqrtHalf, kSqrtHalf, 0}, "a quarter");
    expectNear(pointAt(0.75f, text, {1, 0, 0}), {-kSqrtHalf, kSqrtHalf, 0}, "three quarters");
}

/// Two seconds from 0, leaving by 2 a second, to 1, arriving by -4 a second: Hermite's basis by hand.
TEST_F(GltfPose, CubicSplinesKeepTheirTangents) {
    Parts parts;
    const int times = parts.times({1, 3});
    const int values = parts.vectors({50, 50, 50, 0, 0, 0, 2, 0, 0, -4, 0, 0, 1, 0, 0, 60, 60, 60}, 3);
    const std::string text = gltf(animations(animation({{0, "translation", times, values, "CUBICSPLINE"}})),
                                  kTriangle, R"("nodes": [{"mesh": 0}])", parts.text(), parts.buffer);
    for (const auto& [seconds, x] : {std::pair{0.0f, 0.0f},
                                     {1.0f, 0.0f},
                                     {1.5f, 1.09375f},
                                     {2.0f, 2.0f},
                                     {2.5f, 2.15625f},
                                     {3.0f, 1.0f},
                                     {9.0f, 1.0f}}) {
        const double t = std::clamp((static_cast<double>(seconds) - 1) / 2, 0.0, 1.0);
        const double form =
            2 * (t * t * t - 2 * t * t + t) * 2 + (3 * t * t - 2 * t * t * t) + 2 * (t * t * t - t * t) * -4;
        EXPECT_NEAR(static_cast<double>(x), form, 1e-9) << "the table's own " << seconds;
        expectNear(pointAt(seconds, text), {x, 0, 0}, std::to_string(seconds));
    }
}

TEST_F(GltfPose, MorphTargetsMovePositionsAndNormals) {
    Parts parts;
    const int normals = parts.vectors({0, 0, 1, 0, 0, 1, 0, 0, 1}, 3);
    const int lifted = parts.vectors({0, 0, 2, 0, 0, 4, 0, 0, 6}, 3);
    const int turned = parts.vectors({1, 0, 0, 1, 0, 0, 0, 1, 0}, 3);
    const int aside = parts.vectors({8, 0, 0, 8, 0, 0, 8, 0, 0}, 3);
    const int times = parts.times({0, 2});
    const int weights = parts.add(packed<uint8_t>({0, 255, 255, 0}), kByte, "SCALAR", 4, true);
    const std::string mesh = R"("meshes": [{"weights": [9, 9], "primitives": [{"attributes": {"POSITION": 0,
        "NORMAL": )" + std::to_string(normals) +
                             R"(}, "targets": [{"POSITION": )" + std::to_string(lifted) +
                             ", \"NORMAL\": " + std::to_string(turned) +
                             "}, {\"POSITION\": " + std::to_string(aside) + "}]}]}]";
    const std::string text = gltf(animations(animation({{0, "weights", times, weights}})), mesh,
                                  R"("nodes": [{"mesh": 0}])", parts.text(), parts.buffer);
    for (const float share : {0.0f, 0.25f, 0.5f, 1.0f}) {
        const SceneDescription scene = at(2 * share, text);
        ASSERT_THAT(scene.meshes, SizeIs(1));
        const MeshData& data = *scene.meshes[0].data;
        expectNear(data.positions[1], {1 + 8 * (1 - share), 0, 4 * share}, "a corner");
        expectNear(glm::normalize(data.normals[2]), glm::normalize(Vec3(0, share, 1)), "its normal");
    }
}

/// The joint turns by a right angle about (0, 1, 0): what follows it alone turns with it, what follows both
/// joints equally is at the mean of both places.
TEST_F(GltfPose, SkinsFollowTheirJoints) {
    Parts parts;
    const int joints = parts.add(packed<uint8_t>({0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}), kByte, "VEC4", 3);
    const int weights = parts.vectors({1, 0, 0, 0, 1, 0, 0, 0, 0.5f, 0.5f, 0, 0}, 4);
    const int inverses = parts.add(packed<float>({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0,  0, 1,
                                                  1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1}),
                                   kFloat, "MAT4", 2);
    const int times = parts.times({0, 1});
    const int turns = parts.vectors({0, 0, 0, 1, 0, 0, kSqrtHalf, kSqrtHalf}, 4);
    const std::string mesh = R"("meshes": [{"primitives": [{"attributes": {"POSITION": 0, "JOINTS_0": )" +
                             std::to_string(joints) + ", \"WEIGHTS_0\": " + std::to_string(weights) + "}}]}]";
    const std::string text =
        gltf(R"("skins": [{"joints": [1, 2], "inverseBindMatrices": )" + std::to_string(inverses) + "}], " +
                 animations(animation({{2, "rotation", times, turns}})),
             mesh, R"("scenes": [{"nodes": [0, 1]}], "nodes": [{"mesh": 0, "skin": 0}, {"children": [2]},
                     {"translation": [0, 1, 0]}])",
             parts.text(), parts.buffer);
    for (const double share : {0.0, 0.5, 1.0}) {
        const SceneDescription scene = at(static_cast<float>(share), text);
        ASSERT_THAT(scene.meshes, SizeIs(1));
        const double angle = share * std::numbers::pi / 2;
        const auto turned = [&](double x, double y) {  // about (0, 1)
            return Vec3(x * std::cos(angle) - (y - 1) * std::sin(angle),
                        1 + x * std::sin(angle) + (y - 1) * std::cos(angle), 0);
        };
        const auto& positions = scene.meshes[0].data->positions;
        EXPECT_EQ(positions[0], Vec3(0, 0, 0)) << "its joint rests";
        expectNear(positions[1], turned(1, 0), "of the joint that turns");
        expectNear(positions[2], 0.5f * (Vec3(0, 1, 0) + turned(0, 1)), "of both");
    }
}

/// A sound channel moves the node to (5, 0, 0); each broken one would scale it.
TEST_F(GltfPose, BrokenChannelsAreLeftOutWithOneWarning) {
    Parts parts;
    const int times = parts.times({0, 1}), moves = parts.vectors({5, 0, 0, 5, 0, 0}, 3);
    const int scales = parts.vectors({2, 2, 2, 2, 2, 2}, 3);
    const int falling = parts.times({1, 0}), never = parts.times({0, NAN});
    const int odd = parts.vectors({2, 2, 2}, 3), undefined = parts.vectors({NAN, 2, 2, 2, 2, 2}, 3);
    const int beyond = parts.add(packed<float>({2, 2, 2}), kFloat, "VEC3", 2);
    const auto with = [&](const Channel& channel) {
        return gltf(animations(animation({{0, "translation", times, moves}, channel, channel})), kTriangle,
                    R"("nodes": [{"mesh": 0}])", parts.text(), parts.buffer);
    };
    for (const auto& [channel, why] : std::vector<std::pair<Channel, std::string>>{
             {{0, "scale", falling, scales}, "do not grow"},
             {{0, "scale", never, scales}, "do not grow"},
             {{0, "scale", times, odd}, "has 3 numbers; expected 6"},
             {{0, "scale", times, scales, "CUBICSPLINE"}, "has 6 numbers; expected 18"},
             {{0, "scale", times, undefined}, "is not finite"},
             {{0, "scale", times, beyond}, "end beyond their buffer view"},
             {{0, "scale", times, 99}, "there is no accessor 99"},
             {{0, "scale", -1, scales}, "there is no accessor -1"},
             {{0, "scale", times, scales, "SPLINE"}, "interpolation \"SPLINE\" is unknown"},
             {{0, "pointer", times, scales}, "\"pointer\""},
             {{0, "weights", times, scales}, "has 6 numbers; expected 0"},
             {{99, "scale", times, scales}, "there is no node 99"}}) {
        const SceneDescription scene = at(0.5f, with(channel));
        ASSERT_THAT(scene.objects, SizeIs(1)) << why;
        EXPECT_EQ(scene.objects[0].objectToWorld.point({1, 0, 0}), Vec3(6, 0, 0)) << why;
        EXPECT_THAT(scene.warnings, ElementsAre(testing::AllOf(HasSubstr(why), HasSubstr("(and 1 more)"))));
        EXPECT_FALSE(loadScene(scene.path, {.strict = true})) << why;
    }
    const SceneDescription sound = at(0.5f, with({0, "scale", times, scales}));
    EXPECT_THAT(sound.warnings, IsEmpty());
    EXPECT_EQ(sound.objects[0].objectToWorld.point({1, 0, 0}), Vec3(7, 0, 0));
}

/// Accessors without a buffer state millions of zeros in a few bytes: ten thousand of them are not read.
TEST_F(GltfPose, NumbersAreBoundByTheFile) {
    std::string accessors = R"({"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"})";
    std::vector<Channel> channels;
    for (int i = 1; i <= 10'000; ++i) {
        accessors += R"(,{"componentType": 5126, "count": 16000000, "type": "SCALAR"})";
        channels.push_back({0, "scale", i, i});
    }
    const SceneDescription scene =
        at({}, gltf(animations(animation(channels)), kTriangle, R"("nodes": [{"mesh": 0}])",
                    R"("bufferViews": [{"buffer": 0, "byteLength": 36}], "accessors": [)" + accessors + "]",
                    Parts().buffer));
    EXPECT_THAT(scene.warnings, ElementsAre(HasSubstr("more numbers than its bytes can")));
}

}  // namespace
}  // namespace glint

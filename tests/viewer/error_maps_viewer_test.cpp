// The maps of SPPM's bias and of the bound at 90 % by script: what the window shows of them is what the EXR
// file's layers hold, alone and compared, and path tracing says that it has no bias.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/exr_io.h"
#include "engine/io/image_io.h"
#include "tests/viewer/play_script.h"
#include "viewer/window/shown_image_source.h"

namespace glint {
namespace {

using namespace test;
using testing::HasSubstr;

constexpr int kWidth = 64, kHeight = 48;

// Without light by photons a lone sphere gets none.
constexpr const char* kSppm = R"(
set "Integrator" SPPM
wait frames 2
set "Photons" 2000
set "Direct light" "By photons"
)";

constexpr const char* kLayers = R"(
open "Checkpoint"
wait frames 2
set "32-bit float" on
set "Layers" on
)";

/// Moves the mouse to each place and prints what the status line says of its pixel.
std::string readouts(const std::vector<Vec2i>& places) {
    std::string script;
    for (const Vec2i& at : places) {
        script += fmt::format("move {} {}\nwait frames 3\nprint \"Status line\"\n", at.x, at.y);
    }
    return script;
}

struct Readout {
    Vec2i pixel{-1, -1};
    std::string text;
};

/// The status lines that were printed, in order.
std::vector<Readout> readoutsOf(const Ran& ran) {
    std::vector<Readout> found;
    const std::string begin = "\"Status line\" ";
    for (size_t at = ran.output.find(begin); at != std::string::npos; at = ran.output.find(begin, at + 1)) {
        const std::string line = ran.output.substr(at, ran.output.find('\n', at) - at);
        Readout readout;
        const size_t open = line.find('(');
        if (open != std::string::npos &&
            std::sscanf(line.c_str() + open, "(%d, %d)", &readout.pixel.x, &readout.pixel.y) == 2) {
            readout.text = line.substr(line.find(')', open) + 3);
        }
        found.push_back(readout);
    }
    return found;
}

std::vector<float> layer(const std::string& file, const char* name) {
    const auto loaded = loadExr(file);
    if (!loaded) { return {}; }
    const ExrChannel* channel = loaded->find(name);
    return channel != nullptr ? channel->floats : std::vector<float>{};
}

void expectBound(const Readout& readout, const std::vector<float>& bounds) {
    ASSERT_GE(readout.pixel.x, 0) << readout.text;
    ASSERT_EQ(bounds.size(), static_cast<size_t>(kWidth * kHeight));
    const float bound = bounds[static_cast<size_t>(readout.pixel.y * kWidth + readout.pixel.x)];
    EXPECT_GT(bound, 0.0f);
    EXPECT_EQ(readout.text, fmt::format("within ± {:.3g} luminance at 90 %", bound));
}

/// Of the middle of a picture's pixel in the screenshot, 0 to 255.
const uint8_t* colorOf(const Image8& screenshot, int x, int y) {
    // A whole number of screen pixels for each, as many as there is room for beside the panels.
    constexpr float kAreaWidth = 902.0f, kAreaHeight = 696.0f;
    const float zoom = std::floor(std::min(kAreaWidth / kWidth, kAreaHeight / kHeight));
    const float left = std::floor((kAreaWidth - zoom * kWidth) / 2.0f);
    const float top = std::floor((kAreaHeight - zoom * kHeight) / 2.0f);
    const int atX = static_cast<int>(left + zoom * (static_cast<float>(x) + 0.5f));
    const int atY = static_cast<int>(top + zoom * (static_cast<float>(y) + 0.5f));
    return screenshot.rgb.data() + static_cast<size_t>((atY * screenshot.width + atX) * 3);
}

constexpr int kRowsAboveScale = kHeight - 6;

/// The picture's pixels in the screenshot have the colours of these values.
void expectColors(const std::string& screenshot, const FilmSnapshot& snapshot, ShownImage shown) {
    MapScale scale;
    const std::vector<uint8_t> colors = falseColors(snapshot, shown, nullptr, &scale);
    const auto image = loadImage8(screenshot);
    ASSERT_TRUE(image);
    int wrong = 0;
    for (int i = 0; i < kWidth * kRowsAboveScale; ++i) {
        const uint8_t* color = colorOf(**image, i % kWidth, i / kWidth);
        for (int c = 0; c < 3; ++c) {
            wrong += std::abs(color[c] - colors[static_cast<size_t>(i * 4 + c)]) > 2;
        }
    }
    EXPECT_EQ(wrong, 0) << screenshot;
}

/// Orange where the bias is above 0, blue where it is below.
void expectSigns(const std::string& screenshot, const std::vector<float>& bias) {
    const auto image = loadImage8(screenshot);
    ASSERT_TRUE(image);
    int above = 0, below = 0, wrong = 0;
    for (int i = 0; i < kWidth * kRowsAboveScale; ++i) {
        const uint8_t* color = colorOf(**image, i % kWidth, i / kWidth);
        const int redder = static_cast<int>(color[0]) - static_cast<int>(color[2]);
        const float value = bias[static_cast<size_t>(i)];
        above += redder > 0;
        below += redder < 0;
        wrong += static_cast<float>(redder) * value < 0.0f || (value == 0.0f && redder != 0);
    }
    EXPECT_GT(above, 10);
    EXPECT_GT(below, 10);
    EXPECT_EQ(wrong, 0);
}

TEST(ErrorMapsViewer, BiasAndBoundAreThoseOfTheFile) {
    const std::vector<Vec2i> places{{451, 348}, {400, 300}, {500, 420}};
    const Ran ran = play(std::string(kSppm) + "wait finished\n" + kLayers + R"(
set "EXR file" maps.exr
click "Save EXR"
wait jobs
mark
set "Shown" Bias
wait picture
move "Splitter"  # no help covers the picture
wait frames 3
print "Scale"
screenshot "bias.png"
)" + readouts(places) + R"(
set "Shown" "Bounded at 90 %"
wait picture
wait frames 3
print "Scale"
screenshot "bound.png"
)" + readouts(places) + "expect restarts 0\nexpect no-widget \"Note\"\n",
                         "--passes 6");
    expectPlayed(ran);
    EXPECT_THAT(ran.output, HasSubstr(" bias\n"));
    EXPECT_THAT(ran.output, HasSubstr(" bound at 90 %\n"));
    FilmSnapshot ofFile;
    ofFile.width = kWidth;
    ofFile.height = kHeight;
    ofFile.integrator = IntegratorKind::Sppm;
    ofFile.bias = layer("maps.exr", "bias.Y");
    ofFile.errorBound = layer("maps.exr", "errorBound.Y");
    ASSERT_EQ(ofFile.bias.size(), static_cast<size_t>(kWidth * kHeight));
    ASSERT_EQ(ofFile.errorBound.size(), ofFile.bias.size());
    EXPECT_LT(*std::ranges::min_element(ofFile.bias), 0.0f);
    EXPECT_GT(*std::ranges::max_element(ofFile.bias), 0.0f);
    const auto read = readoutsOf(ran);
    ASSERT_EQ(read.size(), 6u) << ran.output;
    for (size_t i = 0; i < places.size(); ++i) {
        ASSERT_GE(read[i].pixel.x, 0) << ran.output;
        const float bias = ofFile.bias[static_cast<size_t>(read[i].pixel.y * kWidth + read[i].pixel.x)];
        EXPECT_NE(bias, 0.0f);
        EXPECT_EQ(read[i].text, fmt::format("bias {:+.3g} luminance", bias));
        expectBound(read[i + places.size()], ofFile.errorBound);
    }
    expectColors("bias.png", ofFile, ShownImage::Bias);
    expectSigns("bias.png", ofFile.bias);
    expectColors("bound.png", ofFile, ShownImage::ErrorBound);
}

TEST(ErrorMapsViewer, ComparedEachSideShowsItsOwnBound) {
    const Ran ran = play(std::string(kSppm) + "wait passes 5\n" + kLayers + R"(
set "Integrator" "Path tracing"
wait passes 5
key c
key space
wait paused
set "Shown" "Bounded at 90 %"
wait picture
wait frames 3
)" + readouts({{400, 330}, {500, 330}}) +
                         R"(
set "EXR file" path.exr
click "Save EXR"
wait jobs
set "Integrator" SPPM
wait picture
set "EXR file" sppm.exr
click "Save EXR"
wait jobs
)");
    expectPlayed(ran);
    const auto read = readoutsOf(ran);
    ASSERT_EQ(read.size(), 2u) << ran.output;
    const std::vector<float> ofPath = layer("path.exr", "errorBound.Y");
    EXPECT_TRUE(layer("path.exr", "bias.Y").empty()) << "of SPPM alone";
    expectBound(read[0], ofPath);
    expectBound(read[1], layer("sppm.exr", "errorBound.Y"));
    EXPECT_NE(ofPath, layer("sppm.exr", "errorBound.Y"));
}

TEST(ErrorMapsViewer, PathTracingSaysThatItHasNoBias) {
    const Ran ran = play(std::string(R"(
wait picture
set "Shown" Bias
wait picture
wait frames 3
print "Note"
expect no-widget "Scale"
)") + readouts({{451, 348}}) +
                         kSppm + R"(
wait passes 2
wait frames 3
expect no-widget "Note"
expect widget "Scale"
key c
wait picture
wait frames 3
print "Note"
expect widget "Scale"
screenshot "note.png"
set "Shown" "Photon count"
wait picture
wait frames 3
print "Note"
set "Shown" "Bounded at 90 %"
wait picture
wait frames 3
expect no-widget "Note"
)");
    expectPlayed(ran);
    const std::string bias = "\"Note\" Path tracing has no bias: its radiance\n";
    const size_t first = ran.output.find(bias);
    ASSERT_NE(first, std::string::npos) << ran.output;
    EXPECT_NE(ran.output.find(bias, first + 1), std::string::npos) << "compared: " << ran.output;
    EXPECT_THAT(ran.output, HasSubstr("\"Note\" Path tracing has no photons: its radiance\n"));
    const auto read = readoutsOf(ran);
    ASSERT_EQ(read.size(), 1u);
    EXPECT_THAT(read[0].text, testing::StartsWith("R "));
}

}  // namespace
}  // namespace glint

// Drawings: texts that are safe in any file, equal layout at any scale, limits of size; and the legend below
// error maps.
#include "engine/report/drawing.h"

#include <algorithm>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/report/map_legend.h"
#include "tests/support/formula_images.h"

namespace glint {
namespace {

using testing::HasSubstr;

const std::string kReplacement = "\xef\xbf\xbd";

TEST(DrawingText, KeepsWhatIsValid) {
    for (const std::string& text :
         {std::string("plain"), std::string("\u00e9\u2026\u4e2d\U0001f600"), std::string()}) {
        EXPECT_EQ(cleanText(text), text);
    }
}

TEST(DrawingText, ReplacesWhatIsNot) {
    EXPECT_EQ(cleanText("a\x01\x7f"), "a" + kReplacement + kReplacement);
    EXPECT_EQ(cleanText("\xc3"), kReplacement) << "cut short";
    EXPECT_EQ(cleanText("\xc0\xaf"), kReplacement + kReplacement) << "longer than needed";
    EXPECT_EQ(cleanText("\xed\xa0\x80").substr(0, 3), kReplacement) << "half of a pair";
    EXPECT_EQ(cleanText("\xf4\x90\x80\x80").substr(0, 3), kReplacement) << "beyond the last character";
    EXPECT_EQ(cleanText("\xc2\x9b"
                        "31m")
                  .substr(0, 3),
              kReplacement)
        << "a C1 control";
}

TEST(DrawingText, ShortenedTextsFitAndStayValid) {
    const std::string text = "Gr\u00f6\u00dfe \u4e2d\u6587 and more words than there is room for";
    for (double width = 5.0; width < 400.0; width += 7.0) {
        const std::string cut = shortened(text, 13.0, width);
        EXPECT_EQ(cleanText(cut), cut);
        EXPECT_TRUE(textWidth(cut, 13.0) <= width || cut == "\u2026") << width;
    }
    EXPECT_EQ(shortened(text, 13.0, 1e6), text);
}

TEST(Drawing, SizesFollowTheScaleWithinLimits) {
    const Drawing drawing{.width = 30, .height = 20, .title = {}, .shapes = {}};
    EXPECT_EQ(drawingImage(drawing, 2.0).width, 60);
    EXPECT_EQ(drawingImage(drawing, 2.0).rgb, std::vector<uint8_t>(3 * 60 * 40, 255));
    for (const double scale : {0.0, -1.0, 1e9, 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
        EXPECT_EQ(drawingImage(drawing, scale).width, 0) << scale;
    }
}

TEST(Drawing, PaintsWhereItIsTold) {
    Drawing drawing{.width = 10, .height = 10, .title = {}, .shapes = {}};
    drawing.shapes.emplace_back(Polygon{.points = {{2, 3}, {5, 3}, {5, 6}, {2, 6}}, .fill = {10, 200, 30}});
    const Image8 image = drawingImage(drawing, 1.0);
    for (int y = 0; y < 10; ++y) {
        for (int x = 0; x < 10; ++x) {
            const bool inside = x >= 2 && x < 5 && y >= 3 && y < 6;
            EXPECT_EQ(image.rgb[static_cast<size_t>(3 * (10 * y + x))], inside ? 10 : 255) << x << " " << y;
        }
    }
    EXPECT_THAT(drawingSvg(drawing), HasSubstr("<polygon points=\"2,3 5,3 5,6 2,6\" fill=\"#0ac81e\"/>"));
}

TEST(MapLegend, LeavesTheMapAsItIs) {
    for (const auto& [width, height] : {std::pair{1, 1}, std::pair{7, 5}, std::pair{500, 9}}) {
        const auto map = errorMap(ErrorMapKind::Absolute, test::formulaTest(width, height),
                                  test::formulaReference(width, height));
        ASSERT_TRUE(map);
        const MapRange range = readableRange(*map);
        const Image8 colors = falseColors(*map, range);
        const Image8 out = mapWithLegend(*map, range);
        ASSERT_EQ(out.width, std::max(width, kLegendLeastWidth));
        ASSERT_EQ(out.height, height + kLegendHeight);
        for (int y = 0; y < height; ++y) {
            const auto row = out.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y) * out.width;
            EXPECT_TRUE(std::equal(row, row + 3 * width,
                                   colors.rgb.begin() + static_cast<std::ptrdiff_t>(3 * y) * width));
        }
    }
}

TEST(MapLegend, ShowsTheColoursOfItsRange) {
    const auto map = errorMap(ErrorMapKind::Flip, test::formulaTest(400, 9), test::formulaReference(400, 9));
    ASSERT_TRUE(map);
    const Image8 out = mapWithLegend(*map, readableRange(*map));
    const ErrorMap middle{.kind = ErrorMapKind::Flip, .width = 1, .height = 1, .values = {0.5f}};
    const Image8 expected = falseColors(middle, {});
    const size_t row = 3 * static_cast<size_t>(9 + 28) * 400;  // within the bar
    EXPECT_NEAR(out.rgb[row + 3 * 200], expected.rgb[0], 2);
    EXPECT_NEAR(out.rgb[row + 3 * 200 + 1], expected.rgb[1], 2);
    EXPECT_NEAR(out.rgb[row + 3 * 200 + 2], expected.rgb[2], 2);
}

}  // namespace
}  // namespace glint

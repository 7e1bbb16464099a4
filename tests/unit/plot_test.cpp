// Charts by their structure as SVG, and as pixels: nothing lost, nothing on top of each other, nothing that
// breaks a file.
#include "engine/report/plot.h"

#include <cmath>
#include <cstdlib>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/io/image_io.h"
#include "engine/report/log_axis.h"
#include "tests/support/temp_folder.h"

namespace glint {
namespace {

using testing::HasSubstr;
using testing::Not;

/// Errors that fall with the square root of time, with a band of 20 %.
ChartSeries falling(const std::string& name, double error, int points = 12) {
    ChartSeries series{.name = name, .points = {}};
    for (int i = 0; i < points; ++i) {
        const double seconds = 0.1 * std::pow(2.0, i);
        const double y = error / std::sqrt(seconds);
        series.points.push_back({.x = seconds, .y = y, .low = 0.8 * y, .high = 1.2 * y});
    }
    return series;
}

LogLogChart exampleChart() {
    return {.title = "Relative error against run time",
            .subtitle = "cornell.json, 512x512",
            .xTitle = "render time [s]",
            .yTitle = "relative RMSE",
            .note = "Bands: smallest to largest of 4 seeds.",
            .series = {falling("path tracing", 0.3), falling("SPPM", 0.1)},
            .levels = {{.y = 0.002, .label = "reference's own error"}}};
}

size_t count(const std::string& text, const std::string& part) {
    size_t found = 0;
    for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size())) {
        ++found;
    }
    return found;
}

size_t linesWithWidth(const Drawing& drawing, double width) {
    size_t found = 0;
    for (const auto& shape : drawing.shapes) {
        const auto* line = std::get_if<Polyline>(&shape);
        found += line != nullptr && line->width == width ? 1 : 0;
    }
    return found;
}

struct Box {
    double left, top, right, bottom;
    std::string text;
};

std::vector<Box> labelBoxes(const Drawing& drawing) {
    std::vector<Box> boxes;
    for (const auto& shape : drawing.shapes) {
        const auto* label = std::get_if<Label>(&shape);
        if (label == nullptr) { continue; }
        const double width = textWidth(label->text, label->size, label->bold);
        const double share = label->anchor == TextAnchor::Start    ? 0.0
                             : label->anchor == TextAnchor::Middle ? 0.5
                                                                   : 1.0;
        const double x = static_cast<double>(label->position.x);
        const double y = static_cast<double>(label->position.y);
        boxes.push_back(
            label->upwards
                ? Box{x - 0.7 * label->size, y - (1.0 - share) * width, x, y + share * width, label->text}
                : Box{x - share * width, y - 0.7 * label->size, x + (1.0 - share) * width, y, label->text});
    }
    return boxes;
}

/// All labels lie on the paper, and no two on top of each other.
void expectReadable(const LogLogChart& chart) {
    const Drawing drawing = layOutChart(chart);
    const std::vector<Box> boxes = labelBoxes(drawing);
    for (size_t i = 0; i < boxes.size(); ++i) {
        const Box& a = boxes[i];
        EXPECT_TRUE(a.left >= 0.0 && a.top >= 0.0 && a.right <= drawing.width && a.bottom <= drawing.height)
            << a.text;
        for (size_t j = 0; j < i; ++j) {
            const Box& b = boxes[j];
            const bool apart =
                a.right <= b.left + 0.5 || b.right <= a.left + 0.5 || a.bottom <= b.top || b.bottom <= a.top;
            EXPECT_TRUE(apart) << "'" << a.text << "' lies on '" << b.text << "'";
        }
    }
}

/// GLINT_KEEP_PICTURES names a folder that gets the charts, to be looked at.
void keep(const std::string& name, const LogLogChart& chart) {
    if (const char* folder = std::getenv("GLINT_KEEP_PICTURES")) {
        EXPECT_TRUE(saveChart(std::string(folder) + "/" + name + ".png", chart));
        EXPECT_TRUE(saveChart(std::string(folder) + "/" + name + ".svg", chart));
    }
}

TEST(Plot, SvgHoldsEveryPart) {
    const LogLogChart chart = exampleChart();
    const std::string svg = chartSvg(chart);
    for (const char* text :
         {">Relative error against run time<", ">cornell.json, 512x512<", ">render time [s]<",
          ">relative RMSE<", ">path tracing<", ">SPPM<", ">reference&#39;s own error: 0.002<",
          ">Bands: smallest to largest of 4 seeds.<", ">0.1<", ">100<"}) {
        EXPECT_THAT(svg, HasSubstr(text));
    }
    EXPECT_EQ(count(svg, "fill-opacity=\"0.18\""), 2u) << "one band a series";
    EXPECT_EQ(count(svg, "stroke=\"#0072b2\""), 2u) << "the line and its key";
    EXPECT_EQ(count(svg, "fill=\"#0072b2\""), 12u + 1u + 1u) << "markers, the key's, and the band";
    EXPECT_EQ(count(svg, "stroke-dasharray"), 2u) << "the level and its key";
    EXPECT_EQ(linesWithWidth(layOutChart(chart), 2.0), 4u);
    keep("example", chart);
}

TEST(Plot, LabelsNeverOverlapOrLeaveThePaper) {
    LogLogChart chart = exampleChart();
    for (const int width : {1, 320, 500, 960, 2000}) {
        for (const double low : {1e-300, 1e-12, 1e-3, 0.3, 2.0, 1e290}) {
            for (const double factor : {1.0, 1.05, 3.0, 40.0, 1e4, 1e15}) {
                SCOPED_TRACE(testing::Message() << width << " wide, from " << low << " by " << factor);
                chart.width = width;
                chart.series = {{.name = "a series",
                                 .points = {{.x = low, .y = low}, {.x = low * factor, .y = low * factor}}}};
                chart.levels = {{.y = low * 0.5, .label = "level"}};
                expectReadable(chart);
                if ((width == 320 || width == 960) && low == 1e-12) {
                    keep(std::to_string(width) + "_" + std::to_string(std::lround(std::log10(factor))),
                         chart);
                }
            }
        }
    }
}

TEST(Plot, WhatLogarithmicAxesCannotShowIsLeftOutAndSaid) {
    LogLogChart chart = exampleChart();
    const double nan = std::nan("");
    for (const ChartPoint& bad : {ChartPoint{.x = 1.0, .y = 0.0}, ChartPoint{.x = -1.0, .y = 1.0},
                                  ChartPoint{.x = 1.0, .y = nan}, ChartPoint{.x = HUGE_VAL, .y = 1.0}}) {
        chart.series[1].points.push_back(bad);
    }
    const std::string svg = chartSvg(chart);
    EXPECT_THAT(svg, HasSubstr("not finite: 4 of SPPM<"));
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    EXPECT_THAT(svg, Not(HasSubstr("inf")));
    expectReadable(chart);
    keep("left_out", chart);
}

TEST(Plot, NothingToShow) {
    LogLogChart chart = exampleChart();
    chart.series = {{.name = "empty", .points = {}}, {.name = "zeros", .points = {{.x = 0.0, .y = 0.0}}}};
    EXPECT_THAT(chartSvg(chart), HasSubstr("nothing to show"));
    expectReadable(chart);
    keep("empty", chart);
    EXPECT_THAT(chartSvg({}), HasSubstr("nothing to show"));
}

TEST(Plot, OnePointIsAMarkerWithABar) {
    LogLogChart chart = exampleChart();
    chart.series = {{.name = "once", .points = {{.x = 1.0, .y = 0.1, .low = 0.05, .high = 0.2}}}};
    EXPECT_EQ(linesWithWidth(layOutChart(chart), 1.5), 1u);
    expectReadable(chart);
    keep("one_point", chart);
}

TEST(Plot, TipsStayWithTheirPoints) {
    LogLogChart chart = exampleChart();
    chart.series = {{.name = "out of order",
                     .points = {{.x = 2.0, .y = 0.1, .tip = "second"},
                                {.x = 0.0, .y = 0.1, .tip = "left out"},
                                {.x = 1.0, .y = 0.2, .tip = "<first>"}}}};
    const std::string svg = chartSvg(chart);
    const size_t first = svg.find("<title>&lt;first&gt;</title>");
    ASSERT_NE(first, std::string::npos);
    EXPECT_NE(svg.find("<title>second</title>", first), std::string::npos);
    EXPECT_THAT(svg, Not(HasSubstr("left out")));
}

TEST(Plot, BandsThatReachZeroEndAtTheAxis) {
    LogLogChart chart = exampleChart();
    for (ChartPoint& point : chart.series[0].points) {
        point.low = 0.0;
    }
    const std::string svg = chartSvg(chart);
    EXPECT_THAT(svg, Not(HasSubstr("nan")));
    keep("band_to_zero", chart);
}

TEST(Plot, LevelsFarBelowDoNotStretchTheAxis) {
    LogLogChart chart = exampleChart();
    chart.levels = {{.y = 1e-9, .label = "floor"}, {.y = -1.0, .label = "impossible"}};
    EXPECT_THAT(chartSvg(chart), HasSubstr(">floor: 1e-09 (below)<"));
    EXPECT_EQ(count(chartSvg(chart), "stroke-dasharray"), 2u) << "only the keys";
}

TEST(Plot, ManySeriesGetAPlaceEach) {
    LogLogChart chart = exampleChart();
    chart.series.clear();
    for (int i = 0; i < 40; ++i) {
        chart.series.push_back(falling("series " + std::to_string(i), 0.01 * (i + 1), 5));
    }
    const std::string svg = chartSvg(chart);
    for (int i = 0; i < 40; ++i) {
        EXPECT_THAT(svg, HasSubstr(">series " + std::to_string(i) + "<"));
    }
    expectReadable(chart);
    keep("many", chart);
}

TEST(Plot, HostileNames) {
    LogLogChart chart = exampleChart();
    chart.title = "<script>alert(1)</script> & \"quotes\"";
    chart.series[0].name = "\xff\xfe broken \x01\x1b[31m utf-8 \xc3";
    chart.series[1].name = std::string(500, 'w');
    const std::string svg = chartSvg(chart);
    EXPECT_THAT(svg, Not(HasSubstr("<script")));
    EXPECT_THAT(svg, Not(HasSubstr("\x1b")));
    EXPECT_THAT(svg, HasSubstr("&lt;script&gt;"));
    EXPECT_THAT(svg, HasSubstr("w\u2026<"));
    expectReadable(chart);
    keep("hostile", chart);
}

TEST(Plot, FilesAreSavedWholeAndDecode) {
    const test::TempFolder folder;
    ASSERT_TRUE(saveChart(folder.path("a.png"), exampleChart()));
    ASSERT_TRUE(saveChart(folder.path("a.svg"), exampleChart()));
    const auto image = loadImage8(folder.path("a.png"));
    ASSERT_TRUE(image) << image.error().format();
    EXPECT_EQ((*image)->width, 1920);
    EXPECT_EQ((*image)->height, 1200);
    const auto has = [&](uint8_t r, uint8_t g, uint8_t b) {
        for (size_t i = 0; i + 2 < (*image)->rgb.size(); i += 3) {
            if ((*image)->rgb[i] == r && (*image)->rgb[i + 1] == g && (*image)->rgb[i + 2] == b) {
                return true;
            }
        }
        return false;
    };
    EXPECT_TRUE(has(255, 255, 255));
    EXPECT_TRUE(has(0, 114, 178)) << "the first series' colour";
    EXPECT_TRUE(has(213, 94, 0)) << "the second's";
    EXPECT_EQ(test::TempFolder::read(folder.path("a.svg")), chartSvg(exampleChart()));
    EXPECT_EQ(folder.size(), 2u);
    EXPECT_FALSE(saveChart(folder.path("a.pdf"), exampleChart()));
    EXPECT_FALSE(saveChart(folder.path("none/a.svg"), exampleChart()));
}

TEST(LogAxis, RoundsOutwardsToOneTwoFive) {
    const LogAxis axis = axisOver(0.003, 7.0);
    EXPECT_NEAR(std::pow(10.0, axis.low), 0.002, 1e-12);
    EXPECT_NEAR(std::pow(10.0, axis.high), 10.0, 1e-9);
    const LogAxis exact = axisOver(0.001, 1000.0);
    EXPECT_NEAR(exact.low, -3.0, 1e-9);
    EXPECT_NEAR(exact.high, 3.0, 1e-9);
    EXPECT_GE(axisOver(5.0, 5.0).decades(), 0.5);
}

TEST(LogAxis, LabelsFollowTheRoom) {
    const auto labels = [](const LogAxis& axis, double length) {
        std::string out;
        for (const LogTick& tick : logTicks(axis, length, 50.0)) {
            if (tick.labelled) {
                const LogTickText text = tickText(tick, axis);
                out += text.base + (text.exponent.empty() ? "" : "^" + text.exponent) + " ";
            }
        }
        return out;
    };
    EXPECT_EQ(labels({-1.0, 1.0}, 400.0), "0.1 0.2 0.5 1 2 5 10 ");
    EXPECT_EQ(labels({-1.0, 3.0}, 400.0), "0.1 1 10 100 1000 ");
    EXPECT_EQ(labels({-12.0, 3.0}, 160.0), "10^\u221210 10^\u22125 10^0 ");
    EXPECT_EQ(labels({0.0, 0.5}, 600.0), "1 2 3 ");
}

}  // namespace
}  // namespace glint

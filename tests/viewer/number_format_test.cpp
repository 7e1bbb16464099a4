// Numbers in fields: never taken for others, whatever their size.
#include "viewer/base/number_format.h"

#include <cstring>

#include <fmt/printf.h>
#include <gtest/gtest.h>

namespace glint {
namespace {

/// In a field for so many characters.
std::string shown(const char* format, float value, float neighbours = 0.0f, size_t room = 12) {
    const auto fits = [room](const char* text) { return std::strlen(text) <= room; };
    return fmt::sprintf(formatThatShows(format, value, neighbours, fits), static_cast<double>(value));
}

TEST(NumberFormat, UsualNumbersHaveTheFieldsDecimals) {
    EXPECT_EQ(shown("%.3f", 0.5f), "0.500");
    EXPECT_EQ(shown("%.3f", 0.0f), "0.000");
    EXPECT_EQ(shown("%.2f mm", 1.0f), "1.00 mm");
    EXPECT_EQ(shown("%.0f K", 6504.0f), "6504 K");
    EXPECT_EQ(shown("%+.2f stops", -1.5f), "-1.50 stops");
    EXPECT_EQ(shown("–", 7.0f), "–");
}

TEST(NumberFormat, SmallOnesAreNotShownAsZero) {
    EXPECT_EQ(shown("%.2f mm", 0.002f), "0.002 mm");
    EXPECT_EQ(shown("%.3f", 0.0048f), "0.0048");
    EXPECT_EQ(shown("%.3f", -0.00012f), "-0.00012");
    EXPECT_EQ(shown("%.3f", 1e-30f), "1e-30");
    EXPECT_EQ(shown("%.1f°", 1e-6f), "0.0°");
    EXPECT_EQ(shown("%.3f", 1e-7f, 2.0f), "0.000") << "rounding of what stands beside it";
    EXPECT_EQ(shown("%.3f", 1e-7f, 1e-3f), "1e-07");
}

TEST(NumberFormat, LongOnesAreNotCutOff) {
    EXPECT_EQ(shown("%.3f", 12345.678f, 0.0f, 8), "12345.7");
    EXPECT_EQ(shown("%.3f", 1e30f), "1e+30");
    EXPECT_EQ(shown("%.1f mm", -1.25e9f), "-1.25e+09 mm");
    EXPECT_EQ(shown("%.3f", 3.4028e38f, 0.0f, 9), "3.403e+38");
}

}  // namespace
}  // namespace glint

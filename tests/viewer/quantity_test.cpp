// Numbers with units as they are typed, alone and in the window's fields.
#include "viewer/base/quantity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/viewer/play_script.h"

namespace glint {
namespace {

TEST(Quantity, UnitsAndFractionsMeanWhatTheySay) {
    struct Case {
        const char* text;
        const char* unit;
        double value;
    };
    for (const auto& [text, unit, value] : std::initializer_list<Case>{{"35 mm", "m", 0.035},
                                                                       {"50 cm", "m", 0.5},
                                                                       {"2 m", "mm", 2000.0},
                                                                       {"2m", "m", 2.0},
                                                                       {"2,5 cm", "m", 0.025},
                                                                       {"1e-3 m", "mm", 1.0},
                                                                       {"12 in", "cm", 30.48},
                                                                       {"1/3", "", 1.0 / 3.0},
                                                                       {"1/3 stop", "stops", 1.0 / 3.0},
                                                                       {"-1 1/3 stops", "stops", -4.0 / 3.0},
                                                                       {" 2/3 ", "m", 2.0 / 3.0},
                                                                       {"50 %", "", 0.5},
                                                                       {"3", "%", 3.0},
                                                                       {"f/2.8", "", 2.8},
                                                                       {"f 11", "", 11.0},
                                                                       {"1 pass", "passes", 1.0},
                                                                       {"90 deg", "°", 90.0},
                                                                       {"2 min", "s", 120.0},
                                                                       {"1 GiB", "MiB", 1024.0},
                                                                       {"5 W/(sr m²)", "W/(sr m²)", 5.0}}) {
        const Result<double> number = parseQuantity(text, unit);
        ASSERT_TRUE(number) << text << ": " << number.error().message;
        EXPECT_NEAR(*number, value, 1e-9 * std::abs(value)) << text << " in " << unit;
    }
}

TEST(Quantity, WhatDoesNotFitIsRefusedWithAReason) {
    EXPECT_EQ(parseQuantity("35 kg", "m").error().message,
              "has the unit kg, which does not fit here; expected nm, µm, um, mm, cm, m, km, in, ft or none");
    EXPECT_THAT(parseQuantity("3 m", "").error().message, testing::HasSubstr("expected % or none"));
    EXPECT_THAT(parseQuantity("2 s", "passes").error().message,
                testing::HasSubstr("expected passes or none"));
    for (const char* text : {"", "mm", "1/0", "1/2/3", "1 2", "--1", "inf m", "nan", "1 -1/2"}) {
        const Result<double> number = parseQuantity(text, "m");
        ASSERT_FALSE(number) << text << " is " << *number;
        EXPECT_EQ(number.error().message, "is no number") << text;
    }
    for (const char* text : {"3e38 km", "-3e38 km", "1e30/1e-30"}) {
        const Result<double> number = parseQuantity(text, "m");
        ASSERT_FALSE(number) << text << " is " << *number;
        EXPECT_EQ(number.error().message, "is too large") << text;
    }
}

TEST(Quantity, FormatsTellTheirUnit) {
    EXPECT_EQ(unitOfFormat("%.1f mm"), "mm");
    EXPECT_EQ(unitOfFormat("%.2f %%"), "%");
    EXPECT_EQ(unitOfFormat("%+.2f stops"), "stops");
    EXPECT_EQ(unitOfFormat("%.1f°"), "°");
    EXPECT_EQ(unitOfFormat("f/%.2f"), "");
    EXPECT_EQ(unitOfFormat("bounce %d"), "");
    EXPECT_EQ(unitOfFormat("–"), "");
}

TEST(Quantity, FieldsOfTheWindowTakeThem) {
    test::expectPlayed(test::play(R"(wait picture
open "Camera"
set "Position" "50 cm" "1/2" "250 mm"
wait frames 2
expect "Camera/Position" 0.5 0.5 0.25
open "Display"
set "Exposure" "1/2 stop"
wait frames 2
expect "Exposure" 0.5
)"));
    const test::Ran refused = test::play("wait picture\nopen \"Display\"\nset \"Exposure\" \"35 mm\"\n");
    EXPECT_EQ(refused.exitCode, 1);
    EXPECT_THAT(refused.output, testing::HasSubstr("expected a number"));
}

}  // namespace
}  // namespace glint

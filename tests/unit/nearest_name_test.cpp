#include "engine/base/nearest_name.h"

#include <array>

#include <gtest/gtest.h>

namespace glint {
namespace {

constexpr std::array<std::string_view, 6> kNames{"color",    "roughness", "ior",
                                                 "aperture", "metal",     "position"};

TEST(NearestName, FindsSlips) {
    EXPECT_EQ(nearestName("colour", kNames), "color");
    EXPECT_EQ(nearestName("roughnes", kNames), "roughness");
    EXPECT_EQ(nearestName("apreture", kNames), "aperture") << "two neighbours exchanged count as one edit";
    EXPECT_EQ(nearestName("Position", kNames), "position") << "case counts nothing";
    EXPECT_EQ(nearestName("iro", kNames), "ior");
}

TEST(NearestName, EmptyWhenNothingIsNear) {
    EXPECT_EQ(nearestName("subsurface", kNames), "");
    EXPECT_EQ(nearestName("x", kNames), "");
    EXPECT_EQ(nearestName("", kNames), "");
    EXPECT_EQ(nearestName(std::string(100000, 'a'), kNames), "");
    EXPECT_EQ(nearestName("color", {}), "");
}

TEST(NearestName, TheFirstOfEqualsWins) {
    constexpr std::array<std::string_view, 2> kEqual{"bat", "cat"};
    EXPECT_EQ(nearestName("rat", kEqual), "bat");
}

TEST(NearestName, DidYouMeanIsReadyToAppend) {
    EXPECT_EQ(didYouMean("metall", kNames), " (did you mean 'metal'?)");
    EXPECT_EQ(didYouMean("zzzzzz", kNames), "");
}

}  // namespace
}  // namespace glint

// Numbers as people read them.
#include "viewer/base/units.h"

#include <limits>

#include <gtest/gtest.h>

namespace glint {
namespace {

TEST(Units, ErrorsHaveTheirBandWhereItIsKnown) {
    constexpr double kUnknown = std::numeric_limits<double>::infinity();
    EXPECT_EQ(percentWithin(0.026, 0.023, 0.029), "2.60 % ± 0.30");
    EXPECT_EQ(percentWithin(4.487, 1.671, 12.045), "448.7 % ± 519");
    EXPECT_EQ(percentWithin(0.00755, 0.007, 0.0081), "0.76 % ± 0.0550");
    EXPECT_EQ(percentWithin(0.026, 0.0, kUnknown), "2.60 %");
    EXPECT_EQ(percentWithin(0.026, 0.026, 0.026), "2.60 %");
    EXPECT_EQ(percentWithin(kUnknown, kUnknown, kUnknown), "–");
}

}  // namespace
}  // namespace glint

// Exponential and logarithm against libm in double precision.
#include "math/exponential.h"

#include <gtest/gtest.h>

#include <cmath>

namespace obby {
namespace {

TEST(Exponential, AgreesWithLibm) {
  for (float x = 0; x > -79; x -= 0.0137f) {
    EXPECT_NEAR(expNegative(x) / std::exp(double(x)), 1, 3e-7) << x;
  }
  for (float x = -79; x < 79; x += 0.0137f) {
    EXPECT_NEAR(expOf(x) / std::exp(double(x)), 1, 4e-7) << x;
  }
}

TEST(Exponential, SaturatesInsteadOfOverflowing) {
  EXPECT_EQ(expNegative(-100), 0);
  EXPECT_EQ(expOf(-100), 0);
  EXPECT_EQ(expOf(0), 1);
  EXPECT_TRUE(std::isfinite(expOf(1000)));
  EXPECT_GE(expOf(1000), expOf(79));
}

TEST(Logarithm, AgreesWithLibm) {
  for (float x = 1.2e-38f; x < 1e38f; x *= 1.00731f) {
    const double expected = std::log(double(x));
    EXPECT_NEAR(double(logOf(x)), expected, 2e-7 * std::max(1.0, std::fabs(expected))) << x;
  }
  for (float x = 0.5f; x < 2; x += 0.000137f) {
    EXPECT_NEAR(double(logOf(x)), std::log(double(x)), 2e-7) << x;
  }
  EXPECT_EQ(logOf(1), 0);
}

}  // namespace
}  // namespace obby

// Intersections of parts with vertical lines.
#include "policy/solid.h"

#include <gtest/gtest.h>

#include <cstring>

#include "base/random.h"
#include "math/angle.h"

namespace obby::policy {
namespace {

// Does the same as cut(), but without the shortcut for upright parts.
Stretch<float> cutPlainly(const Solid& solid, float x, float z) {
  const Vec3 o{x - solid.center.x, -solid.center.y, z - solid.center.z};
  Stretch<float> s;
  const auto clip = [&](Vec3 axis, float half) {
    const float at = dot(o, axis), inverse = 1.0f / geom::awayFromZero(axis.y);
    const float a = (-half - at) * inverse, b = (half - at) * inverse;
    s.clip(minf(a, b), maxf(a, b));
  };
  clip(solid.axes.x, solid.shape.half.x);
  clip(solid.axes.y, solid.shape.half.y);
  clip(solid.axes.z, solid.shape.half.z);
  return s;
}

// Returns a block with any of its axes pointing up or down, and with zeros of either sign.
Solid uprightBlock(int n, Random& random) {
  const auto uniform = [&random](float lo, float hi) { return lo + (hi - lo) * random.unit(); };
  const SinCos turn = sinCos(Turns(random.next()));
  const float zero = n % 5 == 0 ? -0.0f : 0.0f;
  const Vec3 upright{zero, n % 2 == 0 ? 1.0f : -1.0f, zero};
  const Vec3 one{turn.cos, 0, -turn.sin}, two{turn.sin, 0, turn.cos};
  Solid solid;
  solid.axes = n % 3 == 0   ? Mat3{one, upright, two}
               : n % 3 == 1 ? Mat3{upright, two, one}
                            : Mat3{two, one, upright};
  solid.center = {uniform(-3, 3), n % 7 == 0 ? 0.0f : uniform(-9, 9), uniform(-3, 3)};
  solid.shape.half = {uniform(0.1f, 4), uniform(0.1f, 4), uniform(0.1f, 4)};
  return solid;
}

TEST(Solid, AnUprightBlockIsCutLikeAnyOther) {
  Random random(9, 9);
  int met = 0;
  for (int n = 0; n < 5000; ++n) {
    const Solid solid = uprightBlock(n, random);
    const float x = n % 11 == 0 ? 1e9f : 8 * random.unit() - 4, z = 8 * random.unit() - 4;
    const Stretch<float> is = cut<float>(solid, x, z), expected = cutPlainly(solid, x, z);
    ASSERT_EQ(std::memcmp(&is, &expected, sizeof is), 0)
        << n << ": " << is.bottom << " to " << is.top << ", not " << expected.bottom << " to "
        << expected.top;
    met += is.bottom <= is.top;
  }
  EXPECT_GT(met, 300);
}

}  // namespace
}  // namespace obby::policy

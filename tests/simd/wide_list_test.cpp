// In each lane, a list of lanes equals a scalar list that received the same calls.
#include "simd/wide_list.h"

#include <gtest/gtest.h>

#include <array>

#include "base/random.h"

namespace obby {
namespace {

constexpr int kMax = 6;
using Item = Vec3T<WideFloat>;
using One = LaneList<Vec3, float, kMax>;
using Many = LaneList<Item, WideFloat, kMax>;

Vec3 laneOf(const Item& item, int lane) {
  float x[kLanes], y[kLanes], z[kLanes];
  store(item.x, x), store(item.y, y), store(item.z, z);
  return {x[lane], y[lane], z[lane]};
}

// Each lane adds with its own probability, so lists of all lengths occur.
TEST(WideList, EqualsAScalarListInEachLane) {
  Random random(5, 0);
  for (int round = 0; round < 200; ++round) {
    std::array<One, size_t(kLanes)> one;
    Many many;
    for (int step = 0; step < 8; ++step) {
      float values[kLanes];
      int32_t asked[kLanes];
      for (int lane = 0; lane < kLanes; ++lane) {
        values[lane] = random.unit();
        asked[lane] = random.unit() * float(kLanes) > float(lane);
        one[size_t(lane)].add(asked[lane] != 0, {values[lane], -values[lane], float(step)});
      }
      const WideFloat v = load(values);
      many.add(load(asked) != WideInt(0), Item{v, -v, WideFloat(float(step))});
    }
    int32_t count[kLanes], last[kLanes];
    store(many.count, count);
    for (int lane = 0; lane < kLanes; ++lane) {
      ASSERT_EQ(count[lane], one[size_t(lane)].count);
      last[lane] = count[lane] > 0 ? count[lane] - 1 : 0;
    }
    const Item lasts = many.at(load(last));
    for (int lane = 0; lane < kLanes; ++lane) {
      const One& list = one[size_t(lane)];
      for (int i = 0; i < list.count; ++i) {
        ASSERT_EQ(laneOf(many.at(i), lane), list.at(i)) << i;
        ASSERT_EQ(laneOf(many.next(i), lane), list.next(i)) << i;
      }
      if (list.count == 0) continue;
      ASSERT_EQ(laneOf(lasts, lane), list.at(last[lane]));
    }
  }
}

TEST(WideList, IsEmptyAfterClear) {
  Many many;
  many.add(WideMask(true), Item{});
  many.clear();
  EXPECT_TRUE(all(many.count == 0));
  many.add(WideMask(true), Item{WideFloat(3), WideFloat(), WideFloat()});
  EXPECT_EQ(laneOf(many.at(0), 0).x, 3);
}

}  // namespace
}  // namespace obby

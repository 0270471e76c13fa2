// Rows are divided into as few minibatches as possible, of nearly equal sizes.
#include "nn/minibatches.h"

#include <gtest/gtest.h>

namespace obby::nn {
namespace {

TEST(Minibatches, AreAsFewAsPossibleAndNearlyEqual) {
  for (uint32_t rows = 1; rows <= 60; ++rows) {
    for (uint32_t max = 1; max <= 70; ++max) {
      SCOPED_TRACE(testing::Message() << rows << " rows, at most " << max);
      const Minibatches parts(rows, max);
      EXPECT_GE(parts.count() * max, rows);
      EXPECT_LT((parts.count() - 1) * max, rows) << "one fewer would be enough";
      uint32_t next = 0;
      for (uint32_t i = 0; i < parts.count(); ++i) {
        EXPECT_EQ(parts.first(i), next);
        EXPECT_LE(parts.size(i), parts.largest());
        EXPECT_GE(parts.size(i) + 1, parts.largest());
        next += parts.size(i);
      }
      EXPECT_EQ(next, rows);
      EXPECT_LE(parts.largest(), max);
    }
  }
}

TEST(Minibatches, HaveTheRequestedSizeIfItDividesTheRows) {
  for (const uint32_t count : {1u, 2u, 16u}) {
    const Minibatches parts(4096 * count, 4096);
    EXPECT_EQ(parts.count(), count);
    for (uint32_t i = 0; i < count; ++i) EXPECT_EQ(parts.size(i), 4096u);
  }
}

}  // namespace
}  // namespace obby::nn

// Parts of a batch: as few as there may be, and alike.
#include "train/parts.h"

#include <gtest/gtest.h>

namespace obby::train {
namespace {

TEST(Parts, AreAsFewAsThereMayBeAndOfOneSize) {
  for (uint32_t rows = 1; rows <= 60; ++rows) {
    for (uint32_t most = 1; most <= 70; ++most) {
      SCOPED_TRACE(testing::Message() << rows << " rows, at most " << most);
      const Parts parts(rows, most);
      EXPECT_GE(parts.count() * most, rows);
      EXPECT_LT((parts.count() - 1) * most, rows) << "one less would do";
      uint32_t next = 0;
      for (uint32_t i = 0; i < parts.count(); ++i) {
        EXPECT_EQ(parts.first(i), next);
        EXPECT_LE(parts.size(i), parts.largest());
        EXPECT_GE(parts.size(i) + 1, parts.largest());
        next += parts.size(i);
      }
      EXPECT_EQ(next, rows);
      EXPECT_LE(parts.largest(), most);
    }
  }
}

TEST(Parts, AreAsLargeAsAskedForWhereThatDividesTheRows) {
  for (const uint32_t count : {1u, 2u, 16u}) {
    const Parts parts(4096 * count, 4096);
    EXPECT_EQ(parts.count(), count);
    for (uint32_t i = 0; i < count; ++i) EXPECT_EQ(parts.size(i), 4096u);
  }
}

}  // namespace
}  // namespace obby::train

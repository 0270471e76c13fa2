#include "solve/search/archive/cell_table.h"

#include <gtest/gtest.h>

#include "solve/search/archive/archive_node.h"
#include "solve/search/archive/cell.h"

namespace obby::solve {
namespace {

TEST(CellTable, FindsEveryKeyWhileItGrows) {
  CellTable table;
  const uint32_t cells = 200000;
  for (uint32_t i = 0; i < cells; ++i) {
    ASSERT_EQ(table.find(mixBits(i + 1)), kNone);
    table.add(mixBits(i + 1));
    ASSERT_EQ(table.find(mixBits(i + 1)), i);
  }
  ASSERT_EQ(table.size(), cells);
  for (uint32_t i = 0; i < cells; ++i) ASSERT_EQ(table.find(mixBits(i + 1)), i);
}

TEST(CellTable, KeysWithOneTagAndOneHomeAreDifferentCells) {
  CellTable table;
  const uint64_t key = 0x1234567800000042ull, other = key | 0x40000000u;
  table.add(key);
  EXPECT_EQ(table.find(other), kNone);
  table.add(other);
  EXPECT_EQ(table.find(key), 0u);
  EXPECT_EQ(table.find(other), 1u);
  EXPECT_EQ(table.likely(other), 0u);  // likely only, not certain
}

TEST(CellTable, ZeroIsAKeyAndClustersWrapAround) {
  CellTable table;
  for (uint64_t i = 0; i < 3000; ++i) table.add(i << 32 | 4095);  // all in the last home slot
  table.add(0);
  for (uint32_t i = 0; i < 3000; ++i) ASSERT_EQ(table.find(uint64_t(i) << 32 | 4095), i);
  EXPECT_EQ(table.find(0), 3000u);
  EXPECT_EQ(table.find(4096), kNone);
}

}  // namespace
}  // namespace obby::solve

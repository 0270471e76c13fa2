// Lines of a text by number.
#include "import/document/line_index.h"

#include <gtest/gtest.h>

#include <string>

namespace obby::test {
namespace {

using importer::LineIndex;

TEST(LineIndex, FindsEveryLineByItsNumber) {
  std::string text;
  for (int i = 1; i <= 100; ++i) text += (i > 1 ? "\n" : "") + std::string(size_t(i % 7), 'x');
  const LineIndex lines(text);
  for (int i = 1; i <= 100; ++i) {
    ASSERT_TRUE(lines.line(size_t(i))) << i;
    EXPECT_EQ(*lines.line(size_t(i)), std::string(size_t(i % 7), 'x')) << i;
  }
  EXPECT_FALSE(lines.line(0));
  EXPECT_FALSE(lines.line(101));
}

TEST(LineIndex, TextAfterTheLastLineBreakIsALine) {
  const LineIndex none{}, empty(""), one("a\n");
  EXPECT_FALSE(none.line(1));
  EXPECT_EQ(empty.line(1), "");
  EXPECT_FALSE(empty.line(2));
  EXPECT_EQ(one.line(1), "a");
  EXPECT_EQ(one.line(2), "");
  EXPECT_FALSE(one.line(3));
}

TEST(LineIndex, AMillionEmptyLinesTakeLessThanTheirText) {
  const std::string text(1000000, '\n');
  const LineIndex lines(text);
  EXPECT_EQ(lines.line(1000001), "");
  EXPECT_LE(lines.memory(), text.size() / 2);
}

}  // namespace
}  // namespace obby::test

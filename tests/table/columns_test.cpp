// The width of text on a terminal, and where it is cut.
#include "table/columns.h"

#include <gtest/gtest.h>

namespace obby::table_test {
namespace {

TEST(Columns, TextIsCutBetweenCharactersAndEscaped) {
  EXPECT_EQ(table::fitted("caf\xc3\xa9 noir", 5, false), "caf\xc3\xa9\xe2\x80\xa6");
  EXPECT_EQ(table::fitted("a\x1b[31mb", 20, false), "a [31mb");
  EXPECT_EQ(table::fitted("\xc3\xa9", 5, true), "?");
  EXPECT_EQ(table::fitted("a\xe2\x80\xae"
                          "b\xe2\x80\xa8"
                          "c",
                          20, false),
            "a b c")
      << "U+202E turns a row round, U+2028 ends it";
}

TEST(Columns, CountAsOnATerminal) {
  EXPECT_EQ(table::columnCount("Stage 1"), 7u);
  EXPECT_EQ(table::columnCount("\u30b9\u30c6\u30fc\u30b8"), 8u) << "kana are wide";
  EXPECT_EQ(table::columnCount("\U0001f525"), 2u) << "so are emoji";
  EXPECT_EQ(table::columnCount("e\u0301\u200d"), 1u) << "an accent takes no column of its own";
  EXPECT_EQ(table::columnCount("\u2715\u25cf"), 2u);
  EXPECT_EQ(table::fitted("\u30b9\u30c6\u30fc\u30b8", 6, false), "\u30b9\u30c6\u2026");
  EXPECT_EQ(table::fitted("\u30b9\u30c6\u30fc\u30b8", 8, false), "\u30b9\u30c6\u30fc\u30b8");
  EXPECT_EQ(table::fitted("\u30b9\u30c6\u30fc\u30b8", 4, true), "????");
}

}  // namespace
}  // namespace obby::table_test

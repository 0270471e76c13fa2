// Tests splitting untrusted text into characters, and showing it on a terminal.
#include "io/utf8.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

TEST(Utf8, CharactersAreSplitAndJoined) {
  const std::string text = "a\xc3\xa9\xe2\x82\xac\xf0\x9f\x94\xa5";
  std::string again;
  for (size_t at = 0; at < text.size();) {
    const Utf8Char c = nextChar(text, at);
    at += c.bytes;
    appendUtf8(again, c.code);
  }
  EXPECT_EQ(again, text);
  EXPECT_EQ(nextChar(text, 6).code, U'\U0001f525');
}

TEST(Utf8, AMalformedByteIsOneBrokenCharacter) {
  for (const char* broken : {"\xed\xa0\x80", "\xc0\xaf", "\xe9", "\x9b", "\xf0\x9f\x94"}) {
    const Utf8Char c = nextChar(broken, 0);
    EXPECT_EQ(c.code, U'\ufffd') << broken;
    EXPECT_EQ(c.bytes, 1u) << broken;
  }
}

TEST(Utf8, TextsAreCutBetweenCharacters) {
  EXPECT_EQ(cutAtChar("caf\xc3\xa9", 5), "caf\xc3\xa9");
  EXPECT_EQ(cutAtChar("caf\xc3\xa9", 4), "caf");
  EXPECT_EQ(cutAtChar("caf\xc3\xa9", 0), "");
  EXPECT_EQ(cutAtChar("\xe9\xe9", 1), "\xe9");
}

TEST(Tamed, RemovesCursorMovesAndBidiControls) {
  EXPECT_EQ(tamed("a\x1b[31m\nb\x7f", false), "a [31m b ");
  EXPECT_EQ(tamed("a\xc2\x9b"
                  "b\xc2\x85",
                  false, '?'),
            "a?b?")
      << "U+009B begins a command, U+0085 ends a line";
  EXPECT_EQ(tamed("a\xe2\x80\xae"
                  "b\xe2\x81\xa6"
                  "c\xd8\x9c"
                  "d\xe2\x80\xa8",
                  false, '?'),
            "a?b?c?d?")
      << "U+202E, U+2066, U+061C, U+2028";
  EXPECT_EQ(tamed("caf\xc3\xa9 \xf0\x9f\x94\xa5", false), "caf\xc3\xa9 \xf0\x9f\x94\xa5");
}

TEST(Tamed, ABrokenByteIsVisible) {
  EXPECT_EQ(tamed("a\x9b\xe9", false, '?'), "a\xef\xbf\xbd\xef\xbf\xbd");
  EXPECT_EQ(tamed("a\x9b\xc3\xa9\n", true), "a?? ");
}

}  // namespace
}  // namespace obby::io

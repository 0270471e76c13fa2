// Tests untrusted text in markup, and the byte order mark that some editors add.
#include "io/text.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

TEST(EscapeMarkup, RemovesCharactersThatXmlForbids) {
  EXPECT_EQ(escapeMarkup("<a & \"b\">\n"), "&lt;a &amp; &quot;b&quot;&gt; ");
  EXPECT_EQ(escapeMarkup("a\xef\xbf\xbe<\xef\xbf\xbf"), "a &lt; ") << "U+FFFE and U+FFFF";
  EXPECT_EQ(escapeMarkup("\xef\xbf\xbd\xef\xbf"), "\xef\xbf\xbd\xef\xbf");
}

TEST(NotInXml, FindsCharactersThatNoEntityRepresents) {
  EXPECT_EQ(notInXml("\x01"
                     "a"),
            1u);
  EXPECT_EQ(notInXml("\xef\xbf\xbf"
                     "a"),
            3u);
  for (const char* fine : {"", "a", "\t", "\n", "\r", "<", "\xef\xbf\xbd"})
    EXPECT_EQ(notInXml(fine), 0u) << fine;
}

TEST(ByteOrderMark, IsRemovedOnceAndOnlyIfComplete) {
  EXPECT_EQ(withoutByteOrderMark("\xef\xbb\xbf{}"), "{}");
  EXPECT_EQ(withoutByteOrderMark("\xef\xbb\xbf\xef\xbb\xbf"), "\xef\xbb\xbf");
  for (const char* none : {"", "{}", "\xef\xbb"}) EXPECT_EQ(withoutByteOrderMark(none), none);
}

// Terminals also show JSON messages.
TEST(Quoted, EscapesCursorMovesAndBidiControls) {
  EXPECT_EQ(quoted("a\x1b[31m\"\n\x7f"), "\"a\\u001b[31m\\\"\\n\\u007f\"");
  EXPECT_EQ(quoted("a\xc2\x9b"
                   "b\xe2\x80\xae"),
            "\"a\\u009bb\\u202e\"");
  EXPECT_EQ(quoted("caf\xc3\xa9\xe9"), "\"caf\xc3\xa9?\"");
}

TEST(Described, QuotesTextAndNamesBinaryData) {
  EXPECT_EQ(described("part,x\n"), "\"part,x\\n\"");
  EXPECT_EQ(described("caf\xc3"), "\"caf?\"") << "a character that the end cuts is text";
  for (const std::string_view binary :
       {std::string_view("\xff\xd8\xff\xe0\0\x10JF", 8), std::string_view("\x89PNG\r\n\x1a\n"),
        std::string_view("a\xff\xff\xff\xff"), std::string_view("\xc3")})
    EXPECT_EQ(described(binary), "binary data");
}

}  // namespace
}  // namespace obby::io

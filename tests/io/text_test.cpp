// Texts of others inside of markup.
#include "io/text.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

TEST(EscapeMarkup, LeavesNothingThatXmlCannotHold) {
  EXPECT_EQ(escapeMarkup("<a & \"b\">\n"), "&lt;a &amp; &quot;b&quot;&gt; ");
  EXPECT_EQ(escapeMarkup("a\xef\xbf\xbe<\xef\xbf\xbf"), "a &lt; ") << "U+FFFE and U+FFFF";
  EXPECT_EQ(escapeMarkup("\xef\xbf\xbd\xef\xbf"), "\xef\xbf\xbd\xef\xbf");
}

}  // namespace
}  // namespace obby::io

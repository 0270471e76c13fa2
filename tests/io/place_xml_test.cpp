// Arbitrary names in a place file.
#include "io/place_xml.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

std::string begun(std::string_view name) {
  std::string out;
  PlaceXml(out).begin("Part", name);
  const size_t begin = out.find("<string name=\"Name\">") + 20, end = out.find("</string>");
  return out.substr(begin, end - begin);
}

TEST(PlaceXml, NamesAreEscapedWithoutInvalidCharacters) {
  EXPECT_EQ(begun("a<b>&\tc"), "a&lt;b&gt;&amp;\tc");
  EXPECT_EQ(begun("a\x01z"), "a z");
  EXPECT_EQ(begun("a\xef\xbf\xbez\xef\xbf\xbf"), "a z ") << "U+FFFE and U+FFFF";
  EXPECT_EQ(begun("\xef\xbf\xbd \xc3\xa9"), "\xef\xbf\xbd \xc3\xa9");
}

}  // namespace
}  // namespace obby::io

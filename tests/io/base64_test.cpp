// Encodes bytes as base64 and decodes them.
#include "io/base64.h"

#include <gtest/gtest.h>

namespace obby::io {
namespace {

TEST(Base64, EncodesWithPaddingAndWithoutLineBreaks) {
  EXPECT_EQ(encodeBase64(""), "");
  EXPECT_EQ(encodeBase64("f"), "Zg==");
  EXPECT_EQ(encodeBase64("fo"), "Zm8=");
  EXPECT_EQ(encodeBase64("foo"), "Zm9v");
  EXPECT_EQ(encodeBase64(std::string("\0\xff\x7f", 3)), "AP9/");
  EXPECT_EQ(encodeBase64(std::string(300, 'a')).size(), 400u);
}

TEST(Base64, DecodesWithWhiteSpaceAndWithoutPadding) {
  EXPECT_EQ(decodeBase64(""), "");
  EXPECT_EQ(decodeBase64("Zg=="), "f");
  EXPECT_EQ(decodeBase64("Zg"), "f");
  EXPECT_EQ(decodeBase64(" Zm\n9v\tZ\r\nm8= "), "foofo");
  EXPECT_EQ(decodeBase64("AP9/"), std::string("\0\xff\x7f", 3));
}

TEST(Base64, OtherTextIsRefused) {
  for (const char* text : {"***", "Zm9v*", "Zg==Zg==", "Zm-_", "Z"})
    EXPECT_EQ(decodeBase64(text), std::nullopt) << text;
  EXPECT_EQ(decodeBase64(std::string_view("Zm9v\0", 5)), std::nullopt);
}

TEST(Base64, EveryLengthComesBack) {
  std::string bytes;
  for (int i = 0; i < 300; ++i) {
    EXPECT_EQ(decodeBase64(encodeBase64(bytes)), bytes);
    bytes += char(i * 37);
  }
}

}  // namespace
}  // namespace obby::io

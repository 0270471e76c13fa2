// Tests the blobs that store attributes and tags.
#include "import/format/attributes.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/place_columns.h"
#include "support/place_writer.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

std::string attributeBytes(const std::string& name, uint8_t kind, const std::string& value) {
  std::string out;
  appendString(out, name);
  return out + static_cast<char>(kind) + value;
}
std::string counted(uint32_t count, const std::string& attributes) {
  std::string out;
  append(out, count);
  return out + attributes;
}

TEST(Attributes, EveryKindThatLevelsUseIsRead) {
  const CFrame frame = {{1, 2, 3}, {{0, 0, -1}, {0, 1, 0}, {1, 0, 0}}};
  const CFrame tilted = {{0, 0, 0}, {{0.6f, 0.8f, 0}, {-0.8f, 0.6f, 0}, {0, 0, 1}}};
  const DecodedAttributes decoded =
      decodeAttributes(encodeAttributes({{"bool", true},
                                         {"int", int64_t{-5}},
                                         {"number", 2.5},
                                         {"text", std::string("a\0b", 3)},
                                         {"vector", Vec3{1, 2, 3}},
                                         {"frame", frame},
                                         {"tilted", tilted},
                                         {"color", ColorRgb{0, 102, 255}},
                                         {"udim", UDim{123, 456}},
                                         {"enum", EnumItem{256, "Material"}}}));
  EXPECT_EQ(decoded.warning, "");
  ASSERT_EQ(decoded.values.size(), 10u);
  const auto& v = decoded.values;
  EXPECT_EQ(std::get<bool>(v.at("bool")), true);
  EXPECT_EQ(std::get<int64_t>(v.at("int")), -5);
  EXPECT_EQ(std::get<double>(v.at("number")), 2.5);
  EXPECT_EQ(std::get<std::string>(v.at("text")), std::string("a\0b", 3));
  EXPECT_EQ(std::get<Vec3>(v.at("vector")), (Vec3{1, 2, 3}));
  EXPECT_EQ(std::get<CFrame>(v.at("frame")).rotation.x, (Vec3{0, 0, -1}));
  EXPECT_EQ(std::get<CFrame>(v.at("tilted")).rotation.y, (Vec3{-0.8f, 0.6f, 0}));
  EXPECT_EQ(std::get<ColorRgb>(v.at("color")).g, 102);
  EXPECT_EQ(std::get<UDim>(v.at("udim")).offset, 456);
  EXPECT_EQ(std::get<EnumItem>(v.at("enum")).type, "Material");
}

TEST(Attributes, UnusedKindsAreSkipped) {
  std::string keys;
  append(keys, 2);
  std::string font(3, '\1');
  appendString(font, "family");
  appendString(font, "");
  std::string single, number;
  appendFloat(single, 1.5f);
  append(number, 1004);
  const DecodedAttributes decoded = decodeAttributes(counted(
      10, attributeBytes("udim2", 0x0a, std::string(16, 'u')) +
              attributeBytes("vector2", 0x10, std::string(8, 'v')) +
              attributeBytes("numbers", 0x17, keys + std::string(24, 'n')) +
              attributeBytes("colors", 0x19, keys + std::string(40, 'c')) +
              attributeBytes("range", 0x1b, std::string(8, 'r')) +
              attributeBytes("rect", 0x1c, std::string(16, 'r')) +
              attributeBytes("font", 0x21, font) + attributeBytes("single", 0x05, single) +
              attributeBytes("brick", 0x0e, number) + attributeBytes("last", 0x03, "\x01")));
  EXPECT_EQ(decoded.warning, "");
  EXPECT_EQ(decoded.values.size(), 10u);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(decoded.values.at("font")));
  EXPECT_EQ(std::get<double>(decoded.values.at("single")), 1.5);
  EXPECT_EQ(std::get<ColorRgb>(decoded.values.at("brick")).r, 255);
  EXPECT_TRUE(std::get<bool>(decoded.values.at("last")));
}

TEST(Attributes, AnUnknownKindKeepsEarlierAttributes) {
  const DecodedAttributes decoded = decodeAttributes(
      counted(3, attributeBytes("first", 0x03, "\x01") + attributeBytes("odd", 0x7f, "???") +
                     attributeBytes("lost", 0x03, "\x01")));
  EXPECT_THAT(decoded.warning, HasSubstr("'odd' has the unknown type 0x7f"));
  EXPECT_EQ(decoded.values.size(), 1u);
  EXPECT_EQ(decoded.values.count("first"), 1u);
}

TEST(Attributes, EveryTruncationKeepsWholeAttributesOnly) {
  const std::string blob = encodeAttributes(
      {{"a", 1.0}, {"b", std::string("text")}, {"c", CFrame{}}, {"d", EnumItem{1, "X"}}});
  EXPECT_EQ(decodeAttributes("").warning, "");
  for (size_t length = 1; length < blob.size(); ++length) {
    const DecodedAttributes decoded = decodeAttributes(std::string_view(blob).substr(0, length));
    EXPECT_LT(decoded.values.size(), 4u) << length;
    EXPECT_THAT(decoded.warning, HasSubstr("end early")) << length;
  }
}

TEST(Attributes, AClaimedCountAllocatesNothing) {
  const DecodedAttributes decoded = decodeAttributes(counted(0xffffffff, ""));
  EXPECT_TRUE(decoded.values.empty());
  EXPECT_THAT(decoded.warning, HasSubstr("end early"));
}

TEST(Attributes, AttributesBeyondAThousandAreDropped) {
  const auto blob = [](int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += attributeBytes("a" + std::to_string(i), 0x03, "\x01");
    // The repeated name `a0` adds no entry.
    return counted(static_cast<uint32_t>(count) + 1, all + attributeBytes("a0", 0x03, "\x01"));
  };
  const DecodedAttributes fits = decodeAttributes(blob(1000));
  EXPECT_EQ(fits.warning, "");
  EXPECT_EQ(fits.values.size(), 1000u);
  const DecodedAttributes many = decodeAttributes(blob(100000));
  EXPECT_EQ(many.warning,
            "it has more than 1000 attributes; 'a1000' and the attributes after it are lost");
  EXPECT_EQ(many.values.size(), 1000u);
}

TEST(Attributes, AWarningShowsTheBeginningOfALongName) {
  const DecodedAttributes decoded =
      decodeAttributes(counted(1, attributeBytes(std::string(1000000, 'n'), 0x7f, "???")));
  EXPECT_THAT(decoded.warning, HasSubstr("nnn...' has the unknown type 0x7f"));
  EXPECT_LT(decoded.warning.size(), 200u);
}

TEST(Tags, AreSeparatedByNulAndNeverEmpty) {
  EXPECT_THAT(decodeTags(""), testing::IsEmpty());
  EXPECT_THAT(decodeTags("one"), testing::ElementsAre("one"));
  EXPECT_THAT(decodeTags(std::string("b\0\0a\0", 5)), testing::ElementsAre("b", "a"));
  EXPECT_THAT(decodeTags(std::string("b\0a\0b\0b", 7)), testing::ElementsAre("b", "a"));
}

}  // namespace
}  // namespace obby::test

// The XML format as old and new programs write it.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "import/format/read_document.h"
#include "import/format/xml_filter.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

std::string itemWith(const std::string& properties, const std::string& className = "Part") {
  return "<roblox version=\"4\"><Item class=\"" + className + "\" referent=\"R0\"><Properties>" +
         properties + "</Properties></Item></roblox>";
}

Document formatXmlReadOrDie(const std::string& xml) {
  Result<Document> document = readDocument(xml, "f");
  EXPECT_TRUE(document) << document.error().text();
  return document ? *std::move(document) : Document{};
}

Instance readOne(const std::string& properties, const std::string& className = "Part") {
  Document document = formatXmlReadOrDie(itemWith(properties, className));
  return document.instances.empty() ? Instance{} : document.instances[0];
}

TEST(FormatXml, OldColoursBecomeTheColour) {
  const auto colorOf = [](const std::string& properties) {
    const Instance part = readOne(properties);
    const ColorRgb* color = property<ColorRgb>(part, "Color");
    return color ? color->r << 16 | color->g << 8 | color->b : -1;
  };
  EXPECT_EQ(colorOf("<int name=\"BrickColor\">1004</int>"), 0xff0000);
  EXPECT_EQ(colorOf("<int name=\"brickColor\">23</int>"), 0x0d69ac);
  EXPECT_EQ(colorOf("<int name=\"BrickColor\">99999</int>"), 0xa3a2a5);
  EXPECT_EQ(colorOf("<Color3uint8 name=\"Color3uint8\">4278190335</Color3uint8>"), 0x0000ff);
  EXPECT_EQ(colorOf("<Color3uint8 name=\"Color3uint8\">255</Color3uint8>"), 0x0000ff);
  EXPECT_EQ(colorOf("<Color3 name=\"Color\">4294901760</Color3>"), 0xff0000);
  EXPECT_EQ(colorOf("<Color3 name=\"Color\"><R>1</R><G>0.5</G><B>-3</B></Color3>"), 0xff8000);
}

TEST(FormatXml, TheNewerColourWinsInAnyOrder) {
  const std::string old = "<int name=\"BrickColor\">1004</int>";
  const std::string now = "<Color3uint8 name=\"Color3uint8\">4278190335</Color3uint8>";
  for (const std::string& both : {old + now, now + old}) {
    EXPECT_EQ(property<ColorRgb>(readOne(both), "Color")->b, 255) << both;
  }
}

TEST(FormatXml, UnusualNumbersAreRead) {
  const Instance part = readOne(
      "<float name=\"A\">INF</float><float name=\"B\">-INF</float><float name=\"C\">NAN</float>"
      "<float name=\"D\">1.#INF</float><float name=\"E\">-1.#IND</float><double "
      "name=\"F\">1e400</double>"
      "<float name=\"G\">1e-60</float><float name=\"H\"> 0.1 </float><float name=\"I\">+INF</float>"
      "<int64 name=\"J\">18446744073709551615</int64>");
  const auto number = [&part](const char* name) { return *property<double>(part, name); };
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(number("A"), kInfinity);
  EXPECT_EQ(number("B"), -kInfinity);
  EXPECT_TRUE(std::isnan(number("C")));
  EXPECT_EQ(number("D"), kInfinity);
  EXPECT_TRUE(std::isnan(number("E")));
  EXPECT_EQ(number("F"), kInfinity);
  EXPECT_EQ(number("G"), 0.0);
  EXPECT_EQ(number("H"), static_cast<double>(0.1f));
  EXPECT_EQ(number("I"), kInfinity);
  EXPECT_EQ(*property<int64_t>(part, "J"), -1);
}

TEST(FormatXml, ThePropertyDecidesTheKindNotTheElement) {
  const Instance part = readOne(
      "<thing name=\"Anchored\">true</thing><int name=\"Transparency\">1</int>"
      "<CFrame name=\"size\"><X>1</X><Y>2</Y><Z>3</Z></CFrame><int name=\"Material\">512</int>"
      "<odd name=\"Note\">words</odd><odd name=\"Where\"><X>1</X><Y>2</Y><Z>3</Z></odd>");
  EXPECT_EQ(*property<bool>(part, "Anchored"), true);
  EXPECT_EQ(*property<double>(part, "Transparency"), 1.0);
  EXPECT_EQ(*property<Vec3>(part, "Size"), (Vec3{1, 2, 3}));
  EXPECT_EQ(property<EnumItem>(part, "Material")->value, 512u);
  EXPECT_EQ(*property<std::string>(part, "Note"), "words");
  EXPECT_EQ(*property<Vec3>(part, "Where"), (Vec3{1, 2, 3}));
}

TEST(FormatXml, IllegalCharacterReferencesAreSurvivedAndCounted) {
  const Document document = formatXmlReadOrDie(
      itemWith("<string name=\"Grid\">a&#0;b&#x0;&#8;&#1114112;&#65;</string><bool "
               "name=\"Anchored\">true</bool>"));
  const Instance& part = document.instances.at(0);
  EXPECT_EQ(*property<std::string>(part, "Grid"),
            "a\xef\xbf\xbd"
            "b\xef\xbf\xbd\x08\xef\xbf\xbd"
            "A");
  EXPECT_TRUE(*property<bool>(part, "Anchored"));
  EXPECT_THAT(document.warnings,
              testing::ElementsAre(HasSubstr("3 forbidden XML character references")));
}

TEST(FormatXml, TheFilterLeavesLegalContentAlone) {
  for (const std::string legal :
       {"<a>&#9;&#10;&#x41;&amp;#0;</a>", "<a><![CDATA[&#0; ]] > <!-- &#0;]]></a>",
        "<!-- &#0; <![CDATA[ -->", "&#;&#x;&#12", "<![CDATA[&#0;", "<!--&#0;", ""}) {
    EXPECT_EQ(filterXml(legal).text, legal);
    EXPECT_EQ(filterXml(legal).replaced, 0u);
  }
  EXPECT_EQ(filterXml("<!-- x -->&#0;<![CDATA[&#0;]]>&#00;").text,
            "<!-- x -->\xef\xbf\xbd<![CDATA[&#0;]]>\xef\xbf\xbd");
}

TEST(FormatXml, ErrorsBehindReplacedReferencesNameTheBytesOfTheFile) {
  const std::string bad = "<bool name=\"Anchored\">no</bool>";
  const std::string xml = itemWith("<string name=\"S\">&#0;&#000;</string>" + bad);
  const Result<Document> document = readDocument(xml, "f");
  ASSERT_FALSE(document);
  EXPECT_EQ(document.error().place, "byte " + std::to_string(xml.find(bad)));
}

TEST(FormatXml, CommentsDeclarationsAndByteOrderMarksMayComeFirst) {
  const std::string root = itemWith("");
  for (const std::string before :
       {"\xef\xbb\xbf", "<?xml version=\"1.0\" encoding=\"utf-8\"?>\r\n", "<!-- hello -->\n  "}) {
    EXPECT_TRUE(looksLikeRoblox(before + root));
    EXPECT_EQ(mayBeRoblox(before + root), true);
    EXPECT_EQ(formatXmlReadOrDie(before + root).instances.size(), 1u);
  }
}

TEST(FormatXml, ItsFirstBytesIdentifyItOrAreNotEnough) {
  for (const std::string open : {"", "\xef", "\xef\xbb", "\xef\xbb\xbf", " \r\n\t"})
    EXPECT_FALSE(mayBeRoblox(open).has_value()) << open;
  for (const std::string place : {"<", "\xef\xbb\xbf\n<"}) EXPECT_EQ(mayBeRoblox(place), true);
  for (const std::string other : {"{", "\n {", "\xef\xbb\xbf{", "\xef\xbb{", "x"})
    EXPECT_EQ(mayBeRoblox(other), false) << other;
  EXPECT_EQ(mayBeRoblox(std::string(size_t(1), '\0')), false) << "Cap'n Proto";
  EXPECT_EQ(mayBeRoblox(std::string(size_t(1) << 20, ' ')), true) << "who knows";
}

TEST(FormatXml, RefsAndReferentsMayBeMissingOrDouble) {
  const Document document = formatXmlReadOrDie(
      "<roblox version=\"4\"><Item class=\"ObjectValue\" referent=\"A\"><Properties>"
      "<Ref name=\"Value\">B</Ref></Properties></Item>"
      "<Item class=\"ObjectValue\" referent=\"B\"><Properties><Ref "
      "name=\"Value\">null</Ref></Properties></Item>"
      "<Item class=\"ObjectValue\" referent=\"B\"><Properties><Ref "
      "name=\"Value\">gone</Ref></Properties></Item>"
      "<Item class=\"ObjectValue\"/></roblox>");
  ASSERT_EQ(document.instances.size(), 4u);
  EXPECT_EQ(property<Ref>(document.instances[0], "Value")->target, 1u);
  EXPECT_EQ(property<Ref>(document.instances[1], "Value")->target, kNoInstance);
  EXPECT_EQ(property<Ref>(document.instances[2], "Value")->target, kNoInstance);
  EXPECT_THAT(document.warnings, testing::ElementsAre(HasSubstr("'B' occurs twice")));
}

TEST(FormatXml, AddressesComeFromAnyOfTheirElements) {
  const Instance part = readOne(
      "<Content name=\"MeshContent\"><uri>rbxassetid://1</uri></Content>"
      "<ContentId name=\"TextureID\"><url>rbxassetid://2</url></ContentId>"
      "<Content name=\"Other\"><null></null></Content>",
      "MeshPart");
  EXPECT_EQ(*property<std::string>(part, "MeshId"), "rbxassetid://1");
  EXPECT_EQ(*property<std::string>(part, "TextureID"), "rbxassetid://2");
  EXPECT_EQ(*property<std::string>(part, "Other"), "");
}

TEST(FormatXml, DeepNestingIsAnErrorAndNeedsNoStack) {
  const auto nested = [](int depth) {
    std::string xml = "<roblox version=\"4\">";
    for (int i = 0; i < depth; ++i) xml += "<Item class=\"Folder\">";
    for (int i = 0; i < depth; ++i) xml += "</Item>";
    const Result<Document> document = readDocument(xml + "</roblox>", "f");
    return document ? "accepted" : document.error().text();
  };
  EXPECT_EQ(nested(512), "accepted");
  EXPECT_THAT(nested(513), HasSubstr("deeper than 512"));
  EXPECT_THAT(nested(200'000), HasSubstr("deeper than 512"));
}

TEST(FormatXml, StructureMistakesAreErrors) {
  const auto errorOf = [](const std::string& xml) {
    const Result<Document> document = readDocument(xml, "f");
    return document ? "accepted" : document.error().text();
  };
  EXPECT_EQ(errorOf("<roblox version=\"4\"><Item referent=\"A\"/></roblox>"),
            "f:byte 20: Item: the item has no class");
  EXPECT_THAT(errorOf("<roblox version=\"4\"><Item class=\"A\"></roblox>"), HasSubstr("XML"));
  EXPECT_EQ(errorOf("<roblox version=\"4\"></roblox>"), "accepted");
}

}  // namespace
}  // namespace obby::test

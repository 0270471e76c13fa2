// Content that was written in any of the formats reads back the same.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "engine/classes/class_defaults.h"
#include "import/format/read_document.h"
#include "support/document_text.h"
#include "support/sample_place.h"

namespace obby::test {
namespace {

using namespace importer;

Document formatRoundTripReadOrDie(const std::string& bytes) {
  Result<Document> document = readDocument(bytes, "sample");
  EXPECT_TRUE(document) << document.error().text();
  return document ? *std::move(document) : Document{};
}

const Instance& named(const Document& document, const std::string& name) {
  for (const Instance& instance : document.instances) {
    if (instance.name == name) return instance;
  }
  ADD_FAILURE() << "no instance " << name;
  return document.instances.at(0);
}

TEST(FormatRoundTrip, AllFourFormatsGiveTheSameDocument) {
  const PlaceWriter place = samplePlace();
  const Document xml = formatRoundTripReadOrDie(place.xml());
  EXPECT_EQ(xml.format, "rbxlx");
  for (const Packing packing : {Packing::Stored, Packing::Lz4, Packing::Zstd}) {
    const Document binary = formatRoundTripReadOrDie(place.binary(packing));
    EXPECT_EQ(binary.format, "rbxl");
    EXPECT_EQ(binary.instances.size(), 6u);
    EXPECT_EQ(difference(binary, xml), "");
    EXPECT_THAT(binary.warnings, testing::IsEmpty());
  }
}

TEST(FormatRoundTrip, PropertiesHaveTheirNormalisedNamesAndKinds) {
  for (const std::string& bytes : {samplePlace().binary(), samplePlace().xml()}) {
    const Document document = formatRoundTripReadOrDie(bytes);
    const Instance& lava = named(document, "Lava");
    EXPECT_EQ(*property<Vec3>(lava, "Size"), (Vec3{4, 1, 2}));
    EXPECT_EQ(property<EnumItem>(lava, "Shape")->value, 2u);
    EXPECT_EQ(property<ColorRgb>(lava, "Color")->r, 255);
    EXPECT_EQ(property<ColorRgb>(lava, "Color")->b, 10);
    const CFrame* frame = property<CFrame>(lava, "CFrame");
    ASSERT_NE(frame, nullptr);
    EXPECT_EQ(frame->position, tiltedFrame().position);
    EXPECT_EQ(frame->rotation.x, tiltedFrame().rotation.x);
    EXPECT_EQ(frame->rotation.y, tiltedFrame().rotation.y);
    EXPECT_EQ(*property<SharedBlob>(lava, "PhysicalConfigData")->bytes, std::string("a\0b", 3));
    EXPECT_EQ(*property<std::string>(lava, "UniqueId"), "44b188dace632b4702e9c68d004815fc");
    EXPECT_THAT(lava.tags, testing::ElementsAre("KillBrick", "Checkpoint"));
    EXPECT_EQ(std::get<double>(lava.attributes.at("Damage")), 25.0);
    EXPECT_FALSE(lava.properties.contains("Name"));
    EXPECT_FALSE(lava.properties.contains("Tags"));
    EXPECT_FALSE(lava.properties.contains("size"));
  }
}

TEST(FormatRoundTrip, PhysicalPropertiesFollowTheirFlagBits) {
  const Document document = formatRoundTripReadOrDie(samplePlace().binary());
  const auto* lava =
      property<PhysicalProperties>(named(document, "Lava"), "CustomPhysicalProperties");
  const auto ice = get<PhysicalProperties>(named(document, "Ice"), "CustomPhysicalProperties");
  ASSERT_NE(lava, nullptr);
  EXPECT_TRUE(lava->custom);
  EXPECT_EQ(lava->friction, 0.02f);
  EXPECT_EQ(lava->frictionWeight, 3.0f);
  EXPECT_FALSE(ice.custom);  // acoustics alone; no values follow
}

TEST(FormatRoundTrip, PartsOmitClassDefaults) {
  for (const std::string& bytes : {samplePlace().binary(), samplePlace().xml()}) {
    const Document document = formatRoundTripReadOrDie(bytes);
    const Instance& ice = named(document, "Ice");
    EXPECT_FALSE(ice.properties.contains("Anchored"));
    EXPECT_FALSE(get<bool>(ice, "Anchored"));
    EXPECT_FALSE(ice.properties.contains("Shape"));
    EXPECT_TRUE(ice.properties.contains("Color"));
  }
}

TEST(FormatRoundTrip, TreeKeepsParentsBeforeChildrenAndRefsPointToThem) {
  for (const std::string& bytes : {samplePlace().binary(), samplePlace().xml()}) {
    const Document document = formatRoundTripReadOrDie(bytes);
    for (InstanceId id = 0; id < document.instances.size(); ++id) {
      const Instance& instance = document.instances[id];
      if (instance.parent != kNoInstance) {
        EXPECT_LT(instance.parent, id);
      }
      for (const InstanceId child : instance.children) {
        EXPECT_EQ(document.instances[child].parent, id);
      }
    }
    const Ref* primary = property<Ref>(document.instances[0], "PrimaryPart");
    ASSERT_NE(primary, nullptr);
    EXPECT_EQ(document.instances[primary->target].name, "Ice");
  }
}

TEST(FormatRoundTrip, SourceKeepsMarkupAndLineBreaks) {
  for (const std::string& bytes : {samplePlace().binary(), samplePlace().xml()}) {
    const Document document = formatRoundTripReadOrDie(bytes);
    EXPECT_EQ(*property<std::string>(named(document, "KillScript"), "Source"),
              "-- \"kill\" <&>\nlocal x = '&#0;'");
  }
}

TEST(FormatRoundTrip, ModelsAndPlacesAreDistinguished) {
  PlaceWriter model;
  model.add("Part", "Block");
  EXPECT_EQ(formatRoundTripReadOrDie(model.binary()).format, "rbxm");
  EXPECT_EQ(formatRoundTripReadOrDie(model.xml()).format, "rbxmx");
}

TEST(FormatRoundTrip, OtherContentIsRefused) {
  for (const std::string& bytes :
       {std::string(), std::string("{\"type\":\"level\"}"), std::string("<html></html>"),
        std::string("<robloxxx>"), std::string("PK\x03\x04")}) {
    EXPECT_FALSE(looksLikeRoblox(bytes));
    const Result<Document> document = readDocument(bytes, "other.bin");
    ASSERT_FALSE(document);
    EXPECT_THAT(document.error().text(),
                testing::StartsWith("other.bin:byte 0: the file is not a Roblox place"));
  }
}

}  // namespace
}  // namespace obby::test

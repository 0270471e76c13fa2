// Damaged files of both formats cause an error that names a place, or return a document. They never
// cause a crash or a hang.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "import/format/read_document.h"
#include "import/importer.h"
#include "support/place_binary.h"
#include "support/sample_place.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

std::string formatDamageSmallPlace(bool xml, Packing packing) {
  PlaceWriter place;
  const auto workspace = place.add("Workspace", "Workspace");
  const auto part = place.add("Part", "P", workspace);
  place.set(part, "CFrame", cframe(tiltedFrame()))
      .set(part, "size", vec3(1, 2, 3))
      .set(part, "PhysicalConfigData", shared("blob"))
      .set(part, "MeshContent", content("rbxassetid://1"))
      .tag(part, "Kill");
  return xml ? place.xml() : place.binary(packing);
}

class DamagedBinary : public testing::TestWithParam<Packing> {};

TEST_P(DamagedBinary, TruncationAtEveryByteIsAnErrorWithItsPlace) {
  const std::string whole = samplePlace().binary(GetParam());
  for (size_t length = 0; length < whole.size(); ++length) {
    const Result<Document> document = readDocument(whole.substr(0, length), "cut");
    ASSERT_FALSE(document) << length;
    EXPECT_THAT(document.error().place, testing::StartsWith("byte ")) << length;
  }
}

TEST_P(DamagedBinary, EveryFlippedBitGivesADocumentOrAnError) {
  const std::string whole = formatDamageSmallPlace(false, GetParam());
  size_t refused = 0;
  for (size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    const Result<Document> document = readDocument(damaged, "flipped");
    if (!document) {
      ++refused;
      EXPECT_FALSE(document.error().place.empty()) << bit;
    }
  }
  EXPECT_GT(refused, whole.size());  // more than one bit in eight causes an error
}

INSTANTIATE_TEST_SUITE_P(Packings, DamagedBinary,
                         testing::Values(Packing::Stored, Packing::Lz4, Packing::Zstd));

TEST(DamagedXml, TruncationAtEveryByteIsAnErrorWithItsPlace) {
  const std::string whole = samplePlace().xml();
  const size_t end = whole.rfind('>');
  for (size_t length = 0; length < end; ++length) {
    const Result<Document> document = readDocument(whole.substr(0, length), "cut");
    ASSERT_FALSE(document) << length << whole.substr(length);
    EXPECT_THAT(document.error().place, testing::StartsWith("byte ")) << length;
  }
}

TEST(DamagedXml, EveryFlippedBitGivesADocumentOrAnError) {
  const std::string whole = formatDamageSmallPlace(true, Packing::Stored);
  size_t refused = 0;
  for (size_t bit = 0; bit < whole.size() * 8; ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << (bit % 8)));
    if (!readDocument(damaged, "flipped")) ++refused;
  }
  EXPECT_GT(refused, whole.size());
}

// Some files are made to exhaust memory, for example by many parts with names of a megabyte.
TEST(LongNames, AreCutAtAHundredCharactersWithOneWarning) {
  PlaceWriter place;
  const auto workspace = place.add("Workspace", "Workspace");
  std::string name;
  while (name.size() < 100000) name += "\xc3\xa4";  // two bytes each
  const auto folder = place.add("Folder", name, workspace);
  place.add("Folder", std::string(100, 'x'), workspace);
  for (int i = 0; i < 100; ++i) place.set(place.add("Part", "P", folder), "Anchored", flag(true));
  for (const std::string& bytes : {place.binary(), place.xml()}) {
    auto made = importPlace(bytes, "long", {});
    ASSERT_TRUE(made) << made.error().text();
    const auto parts = made->level.reader().getLevel().getParts();
    ASSERT_EQ(parts.size(), 100u);
    EXPECT_EQ(std::string(parts[99].getSource().getPath().cStr()),
              "Workspace/" + name.substr(0, 200) + "/P");
    ASSERT_FALSE(made->warnings.empty());
    EXPECT_EQ(made->warnings.front(), "long: 1 name cut to 100 characters, as in the engine");
    EXPECT_EQ(std::count_if(made->warnings.begin(), made->warnings.end(),
                            [](const auto& w) { return w.find("100 characters") != w.npos; }),
              1);
  }
}

TEST(LongNames, PathsOfDeepTreesKeepTheirEnds) {
  PlaceWriter place;
  auto parent = place.add("Workspace", "Workspace");
  for (int i = 0; i < 400; ++i)
    parent = place.add("Folder", std::to_string(i) + std::string(90, 'f'), parent);
  place.set(place.add("Part", "Last", parent), "Anchored", flag(true));
  auto made = importPlace(place.binary(), "deep", {});
  ASSERT_TRUE(made) << made.error().text();
  const std::string path =
      made->level.reader().getLevel().getParts()[0].getSource().getPath().cStr();
  EXPECT_LT(path.size(), 1200u);
  EXPECT_THAT(path, testing::StartsWith("Workspace/0ff"));
  EXPECT_THAT(path, HasSubstr("/.../"));
  EXPECT_THAT(path, testing::EndsWith("f/Last"));
}

// Each chunk may decompress to 16 MiB, so a file of a few kilobytes may hold only a few chunks.
TEST(HostileBinary, ManySmallChunksThatGrowAreRefused) {
  const std::string grown =
      propertyChunk(0, "Unknown", 0xee, std::string(16 << 20, 0), Packing::Zstd);
  const auto file = [&](int count) {
    std::string bytes = fileHeader(1, 1) + instanceChunk(0, "Part", {0});
    for (int i = 0; i < count; ++i) bytes += grown;
    return bytes + parentChunk({0}, {-1}) + endChunk();
  };
  EXPECT_TRUE(readDocument(file(5), "some"));
  const Result<Document> many = readDocument(file(20), "many");
  ASSERT_FALSE(many);
  EXPECT_THAT(many.error().text(), HasSubstr("the chunks up to this one claim to hold"));
}

TEST(DamagedXml, WrongValuesNameInstancePropertyAndPart) {
  const auto errorOf = [](const std::string& property) {
    const std::string xml = "<roblox version=\"4\"><Item class=\"Part\"><Properties>" + property +
                            "</Properties></Item></roblox>";
    const Result<Document> document = readDocument(xml, "bad.rbxmx");
    return document ? "accepted" : document.error().text();
  };
  EXPECT_EQ(errorOf("<Vector3 name=\"size\"><X>1</X><Y>oops</Y><Z>2</Z></Vector3>"),
            "bad.rbxmx:byte 51: Part.size.Y: expected a number, found 'oops'");
  EXPECT_THAT(errorOf("<bool name=\"Anchored\">maybe</bool>"), HasSubstr("Part.Anchored"));
  EXPECT_THAT(errorOf("<BinaryString name=\"Tags\">***</BinaryString>"), HasSubstr("base64"));
  EXPECT_THAT(errorOf("<SharedString name=\"PhysicalConfigData\">k</SharedString>"),
              HasSubstr("shared string"));
  EXPECT_THAT(errorOf("<CoordinateFrame name=\"CFrame\"><X>1</X></CoordinateFrame>"),
              HasSubstr("Part.CFrame.Y"));
}

}  // namespace
}  // namespace obby::test

// Tests details of the binary format: rotations, chunks with false sizes, invalid trees.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>

#include "import/format/read_document.h"
#include "import/format/rotation.h"
#include "support/place_binary.h"
#include "support/sample_place.h"

namespace obby::test {
namespace {

using namespace importer;
using testing::HasSubstr;

std::string errorOf(const std::string& bytes) {
  const Result<Document> document = readDocument(bytes, "f");
  return document ? "accepted" : document.error().text();
}

// Returns two parts with referents 0 and 1, the second below the first.
std::string twoParts(const std::string& properties, const std::string& parents) {
  return fileHeader(1, 2) + instanceChunk(0, "Part", {0, 1}) + properties + parents + endChunk();
}
std::string goodParents() { return parentChunk({0, 1}, {-1, 0}); }

// Returns the rotation by `degrees`, a multiple of 90, about an axis (0: x, 1: y, 2: z).
Mat3 quarterTurns(int axis, int degrees) {
  const int turns = ((degrees / 90) % 4 + 4) % 4;
  const std::array<float, 4> cosine = {1, 0, -1, 0}, sine = {0, 1, 0, -1};
  const float c = cosine[turns], s = sine[turns];
  if (axis == 0) return {{1, 0, 0}, {0, c, s}, {0, -s, c}};
  if (axis == 1) return {{c, 0, -s}, {0, 1, 0}, {s, 0, c}};
  return {{c, s, 0}, {-s, c, 0}, {0, 0, 1}};
}

TEST(FormatBinary, OnlyAnEditedPivotIsStored) {
  PlaceWriter place;
  place.set(place.add("Part", "Edited"), "PivotOffset", cframe(0, 0, -10));
  place.set(place.add("Part", "Plain"), "PivotOffset", cframe(0, 0, 0));
  for (const std::string& bytes : {place.binary(), place.xml()}) {
    const auto document = readDocument(bytes, "pivots");
    ASSERT_TRUE(document) << document.error().text();
    const auto* offset = property<CFrame>(document->instances[0], "PivotOffset");
    ASSERT_NE(offset, nullptr);
    EXPECT_EQ(offset->position, (Vec3{0, 0, -10}));
    EXPECT_FALSE(document->instances[1].properties.contains("PivotOffset"));
  }
}

TEST(FormatBinary, AllTwentyFourRotationIdsMatchTheAnglesOfTheFormat) {
  struct Row {
    uint8_t id;
    int x, y, z;  // degrees, applied as Y * X * Z
  };
  constexpr Row kRows[] = {
      {0x02, 0, 0, 0},     {0x03, 90, 0, 0},     {0x05, 0, 180, 180},  {0x06, -90, 0, 0},
      {0x07, 0, 180, 90},  {0x09, 0, 90, 90},    {0x0a, 0, 0, 90},     {0x0c, 0, -90, 90},
      {0x0d, -90, -90, 0}, {0x0e, 0, -90, 0},    {0x10, 90, -90, 0},   {0x11, 0, 90, 180},
      {0x14, 0, 180, 0},   {0x15, -90, -180, 0}, {0x17, 0, 0, 180},    {0x18, 90, 180, 0},
      {0x19, 0, 0, -90},   {0x1b, 0, -90, -90},  {0x1c, 0, -180, -90}, {0x1e, 0, 90, -90},
      {0x1f, 90, 90, 0},   {0x20, 0, 90, 0},     {0x22, -90, 90, 0},   {0x23, 0, -90, 180},
  };
  for (const Row& row : kRows) {
    const Mat3 expected =
        quarterTurns(1, row.y) * (quarterTurns(0, row.x) * quarterTurns(2, row.z));
    const auto rotation = rotationFromId(row.id);
    ASSERT_TRUE(rotation) << int{row.id};
    EXPECT_EQ(rotation->x, expected.x) << int{row.id};
    EXPECT_EQ(rotation->y, expected.y) << int{row.id};
    EXPECT_EQ(rotation->z, expected.z) << int{row.id};
  }
  int valid = 0;
  for (int id = 0; id < 256; ++id) valid += rotationFromId(static_cast<uint8_t>(id)) ? 1 : 0;
  EXPECT_EQ(valid, 24);
}

TEST(FormatBinary, UnknownKindsAndChunksAreSkippedWithAWarning) {
  const std::string bytes =
      twoParts(propertyChunk(0, "Odd", 0x7b, "whatever") + chunk("SIGN", "x", Packing::Stored) +
                   chunk("NEW?", "y", Packing::Lz4) + propertyChunk(0, "Anchored", 2, "\x01\x01"),
               goodParents());
  const Result<Document> document = readDocument(bytes, "f");
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_TRUE(propertyOr(document->instances[1], "Anchored", false));
  EXPECT_THAT(document->warnings, testing::ElementsAre(HasSubstr("PROP Part.Odd skipped"),
                                                       HasSubstr("unknown chunk 'NEW?'")));
}

TEST(FormatBinary, WarningsOfAttributesNameTheirInstance) {
  std::string blob, attributes, names;
  append(blob, 1);
  appendString(blob, "odd");
  blob += '\x7f';
  for (const std::string& each : {blob, std::string()}) appendString(attributes, each);
  for (const char* name : {"Lava", "Floor"}) appendString(names, name);
  // As in real files, the names come afterwards.
  const std::string bytes = twoParts(propertyChunk(0, "AttributesSerialize", 0x01, attributes) +
                                         propertyChunk(0, "Name", 0x01, names),
                                     goodParents());
  const Result<Document> document = readDocument(bytes, "f");
  ASSERT_TRUE(document) << document.error().text();
  EXPECT_THAT(document->warnings, testing::ElementsAre(HasSubstr("Part 'Lava': attribute 'odd'")));
}

TEST(FormatBinary, ChunksMayComeInAnyOrder) {
  const std::string bytes = fileHeader(1, 2) + goodParents() +
                            propertyChunk(0, "Anchored", 2, "\x01\x01") +
                            instanceChunk(0, "Part", {0, 1}) + endChunk();
  EXPECT_EQ(errorOf(bytes), "accepted");
}

TEST(FormatBinary, BrokenTreesAreErrors) {
  EXPECT_EQ(errorOf(twoParts("", goodParents())), "accepted");
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0, 1}, {1, 0}))),
              HasSubstr("in a cycle of parents"));
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0, 1}, {-1, 1}))),
              HasSubstr("in a cycle of parents"));
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0, 1}, {-1, 9}))), HasSubstr("missing instance 9"));
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0, 7}, {-1, 0}))), HasSubstr("missing instance 7"));
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0, 0}, {-1, -1}))), HasSubstr("two parents"));
  EXPECT_THAT(errorOf(twoParts("", parentChunk({0}, {-1}))),
              HasSubstr("without an entry in the PRNT chunk"));
  EXPECT_THAT(errorOf(twoParts("", "")), HasSubstr("without an entry in the PRNT chunk"));
}

TEST(FormatBinary, DuplicateOrNegativeReferentsAreErrors) {
  const auto withReferents = [](const std::vector<int32_t>& referents) {
    return errorOf(fileHeader(1, 2) + instanceChunk(0, "Part", referents) + goodParents() +
                   endChunk());
  };
  EXPECT_THAT(withReferents({0, 0}), HasSubstr("INST: Part: referent 0 occurs twice"));
  EXPECT_THAT(withReferents({0, -5}), HasSubstr("referent -5 is negative"));
  EXPECT_THAT(errorOf(fileHeader(1, 2) + instanceChunk(0, "Part", {0}) +
                      instanceChunk(0, "Seat", {1}) + goodParents() + endChunk()),
              HasSubstr("class id 0 is declared twice"));
}

TEST(FormatBinary, PropertiesThatDoNotFitTheirClassAreErrors) {
  const auto withProperty = [](uint32_t classId, uint8_t kind, const std::string& column) {
    return errorOf(twoParts(propertyChunk(classId, "X", kind, column), goodParents()));
  };
  EXPECT_THAT(withProperty(5, 2, "\x01\x01"), HasSubstr("class id 5"));
  EXPECT_EQ(
      withProperty(0, 2, "\x01"),
      "f:byte 73: PROP: Part.X: the data ends early: expected 2 values (save the file again in "
      "Studio)");
  EXPECT_THAT(withProperty(0, 0x10, std::string("\x01\x01", 2) + std::string(24, '\0')),
              HasSubstr("unknown rotation id 1"));
  EXPECT_THAT(withProperty(0, 0x1c, std::string(8, '\0')), HasSubstr("missing shared string 0"));
  EXPECT_THAT(withProperty(0, 0x1e, std::string(1, '\x11')), HasSubstr("expected a CFrame column"));
  // Two values from an address, but no address.
  EXPECT_THAT(withProperty(0, 0x22, std::string("\0\0\0\0\0\0\1\1", 8) + std::string(12, '\0')),
              HasSubstr("the file is damaged: it has more content values than addresses (save"));
  // A string that claims 4 GiB.
  EXPECT_THAT(withProperty(0, 0x01, "\xff\xff\xff\xffzzzz"), HasSubstr("ends early"));
}

TEST(FormatBinary, ClaimedSizesAllocateNothing) {
  const std::string huge("\xff\xff\xff\x3f", 4);  // 1 GiB
  const auto withChunk = [](const std::string& chunkBytes) {
    return errorOf(fileHeader(1, 1) + chunkBytes + endChunk());
  };
  const std::string zero(4, '\0');
  // Chunks that claim huge sizes: stored ones, then compressed ones (LZ4 and zstd).
  EXPECT_THAT(withChunk("INST" + zero + huge + zero + "x"), HasSubstr("but the file ends"));
  EXPECT_THAT(withChunk("INST" + huge + huge + zero + "x"), HasSubstr("but the file ends"));
  EXPECT_THAT(withChunk("INST" + std::string("\x04\0\0\0", 4) + huge + zero + "abcd"),
              HasSubstr("claims to hold 1073741823 bytes; its packed size is 4"));
  EXPECT_THAT(withChunk("INST" + std::string("\x05\0\0\0", 4) + huge + zero + "\x28\xb5\x2f\xfd "),
              HasSubstr("claims to hold 1073741823 bytes; its packed size is 5"));
  // Huge counts inside a chunk.
  std::string instances;
  append(instances, 0);
  appendString(instances, "Part");
  instances += '\0' + huge + "abcdefgh";
  EXPECT_THAT(withChunk(chunk("INST", instances, Packing::Stored)), HasSubstr("ends before its"));
  EXPECT_THAT(withChunk(chunk("SSTR", zero + huge + "abcd", Packing::Zstd)),
              HasSubstr("ends before its"));
  EXPECT_THAT(withChunk(chunk("PRNT", std::string(1, '\0') + huge, Packing::Lz4)),
              HasSubstr("ends before its"));
}

TEST(FormatBinary, DamagedCompressionIsAnError) {
  std::string lz4 = chunk("INST", std::string(100, 'a'), Packing::Lz4);
  lz4[8] = 99;
  EXPECT_THAT(errorOf(fileHeader(0, 0) + lz4 + endChunk()), HasSubstr("LZ4 data is damaged"));
  std::string zstd = chunk("INST", std::string(100, 'a'), Packing::Zstd);
  zstd[8] = 101;
  EXPECT_THAT(errorOf(fileHeader(0, 0) + zstd + endChunk()), HasSubstr("but holds 100"));
  zstd[8] = 99;
  EXPECT_THAT(errorOf(fileHeader(0, 0) + zstd + endChunk()), HasSubstr("zstd data is damaged"));
}

TEST(FormatBinary, FilesMadeToExhaustMemoryAreRefused) {
  // Four million instances in a few kilobytes.
  std::string instances;
  append(instances, 0);
  appendString(instances, "Part");
  instances += '\0';
  append(instances, 4'000'000);
  instances += std::string(12'000'000, '\0') + std::string(4'000'000, '\x02');
  const std::string bytes = fileHeader(1, 1) + chunk("INST", instances, Packing::Zstd) + endChunk();
  ASSERT_LT(bytes.size(), 10'000u);
  EXPECT_THAT(errorOf(bytes), HasSubstr("too large for a file of this size"));
}

TEST(FormatBinary, TagsThatWouldExhaustMemoryAreRefused) {
  // Six million tags in a few kilobytes: the texts alone would take 200 MB.
  const auto withTags = [](size_t count) {
    std::string tags;
    for (size_t i = 0; i < count; ++i) tags += std::string("a\0", 2);
    std::string column;
    appendString(column, tags);
    appendString(column, "");
    return errorOf(twoParts(propertyChunk(0, "Tags", 0x01, column, Packing::Zstd), goodParents()));
  };
  EXPECT_EQ(withTags(1000), "accepted");
  EXPECT_THAT(withTags(6'000'000), HasSubstr("too large for a file of this size"));
}

TEST(FormatBinary, DeepNestingIsAnError) {
  const auto chain = [](int depth) {
    std::vector<int32_t> ids, parents;
    for (int i = 0; i < depth; ++i) {
      ids.push_back(i);
      parents.push_back(i - 1);
    }
    return errorOf(fileHeader(1, static_cast<uint32_t>(depth)) + instanceChunk(0, "Folder", ids) +
                   parentChunk(ids, parents) + endChunk());
  };
  EXPECT_EQ(chain(512), "accepted");
  EXPECT_THAT(chain(513), HasSubstr("deeper than 512"));
  EXPECT_THAT(chain(100'000), HasSubstr("deeper than 512"));
}

TEST(FormatBinary, OtherVersionsAndSignaturesAreErrors) {
  std::string bytes = twoParts("", goodParents());
  bytes[14] = 1;
  EXPECT_EQ(errorOf(bytes),
            "f:byte 14: binary format version 1 is not supported (only version 0 can be read)");
  bytes[14] = 0;
  bytes[9] = 0;
  EXPECT_THAT(errorOf(bytes), HasSubstr("expected the 32-byte header"));
}

TEST(FormatBinary, ReferentsNeedNotAscend) {
  // The steps between referents have both signs: 5, 2, 9.
  const std::string bytes = fileHeader(1, 3) + instanceChunk(0, "Part", {5, 2, 9}) +
                            propertyChunk(0, "Name", 1,
                                          [] {
                                            std::string names;
                                            for (const char* n : {"five", "two", "nine"})
                                              appendString(names, n);
                                            return names;
                                          }()) +
                            parentChunk({9, 5, 2}, {-1, 9, 9}) + endChunk();
  const Result<Document> document = readDocument(bytes, "f");
  ASSERT_TRUE(document) << document.error().text();
  ASSERT_EQ(document->instances.size(), 3u);
  EXPECT_EQ(document->instances[0].name, "nine");
  EXPECT_EQ(document->instances[1].name, "five");
  EXPECT_EQ(document->instances[2].name, "two");
}

}  // namespace
}  // namespace obby::test

// Hostile Cap'n Proto messages cause no crash, no exception, no large allocation and little work.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstring>
#include <ctime>

#include "io/json_codec.h"
#include "io/stream.h"
#include "random_record.h"

namespace obby::io {
namespace {

std::string message(uint32_t seed, Format format, Kind kind = Kind::LEVEL) {
  test::RecordFiller filler(seed, 0.6f, 3);
  std::string bytes;
  StreamWriter writer = StreamWriter::toBytes(format, &bytes);
  EXPECT_TRUE(writer.write(filler.fill(kind).reader()));
  return bytes;
}

// Reads all records. Every accepted record must also be writable.
void digest(const std::string& bytes) {
  StreamReader reader = StreamReader::overBytes(bytes, "in");
  for (int i = 0; i < 100; i++) {
    auto record = reader.next();
    if (!record) {
      EXPECT_FALSE(record.error().message.empty());
      if (!reader.canContinue()) return;
      continue;
    }
    if (!*record) return;
    if (!(*record)->known()) continue;
    auto json = recordToJson((*record)->reader());
    EXPECT_TRUE(json) << json.error().text();
  }
}

double longestSeconds = 0;

void timedDigest(const std::string& bytes) {
  const std::clock_t start =
      std::clock();  // CPU time, since other programs may slow the machine down
  digest(bytes);
  longestSeconds = std::max(longestSeconds, double(std::clock() - start) / CLOCKS_PER_SEC);
}

TEST(HostileMessages, EveryFlippedBitIsSurvived) {
  for (Format format : {Format::capnp, Format::capnpPacked}) {
    for (uint32_t seed = 0; seed < 3; seed++) {
      const std::string whole = message(seed, format);
      for (size_t bit = 0; bit < 8 * std::min<size_t>(whole.size(), 1500); bit++) {
        std::string bytes = whole;
        bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << (bit % 8)));
        timedDigest(bytes);
      }
    }
  }
  EXPECT_LT(longestSeconds, 0.5);
}

TEST(HostileMessages, PairsOfFlippedBitsAreSurvived) {
  Random random(9, 9);
  for (uint32_t round = 0; round < 8000; round++) {
    std::string bytes = message(round % 50, Format::capnp, Kind(1 + round % (test::kKinds - 2)));
    for (int flips = 0; flips < 2 + int(round % 3); flips++) {
      const uint32_t bit = random.below(uint32_t(8 * bytes.size()));
      bytes[bit / 8] = char(bytes[bit / 8] ^ (1 << (bit % 8)));
    }
    timedDigest(bytes);
  }
  EXPECT_LT(longestSeconds, 0.5);
}

TEST(HostileMessages, RandomBytesAreSurvived) {
  Random random(11, 12);
  for (int round = 0; round < 20000; round++) {
    std::string bytes(random.below(64), '\0');
    for (char& c : bytes) c = char(random.below(4) == 0 ? random.below(256) : random.below(6));
    digest(bytes);
  }
}

std::string little32(std::initializer_list<uint32_t> values) {
  std::string out;
  for (uint32_t value : values)
    for (int i = 0; i < 4; i++) out += char(value >> (8 * i));
  return out;
}

std::string errorOf(const std::string& bytes) {
  StreamReader reader = StreamReader::overBytes(bytes, "in");
  auto record = reader.next();
  return record ? "no error" : record.error().text();
}

TEST(HostileMessages, HugeClaimsCostNothing) {
  rusage before{}, after{};
  getrusage(RUSAGE_SELF, &before);
  EXPECT_EQ(errorOf(little32({0, 0x7fffffff})),
            "in:byte 0: expected a message of at most 256 MiB, found 16383 MiB");
  EXPECT_EQ(errorOf(little32({511, 0x2000000})),
            "in:byte 0: the input ends in the middle of a message (the input was cut off; rerun "
            "the tool that wrote it)");
  // The claimed size is below the limit, but the bytes are missing.
  EXPECT_EQ(errorOf(little32({0, 0x1fffffe})),
            "in:byte 0: the input ends in the middle of a message (the input was cut off; rerun "
            "the tool that wrote it)");
  getrusage(RUSAGE_SELF, &after);
  EXPECT_LT(after.ru_maxrss - before.ru_maxrss, 64 << 10);  // KiB
}

TEST(HostileMessages, AListLargerThanTheMessageIsReported) {
  // One segment holds a Record of one data word and one pointer to a Level. The level's first
  // pointer (name) claims 2^28 bytes.
  const std::string bytes =
      little32({0, 10, 0, 0x00010001, 1, 0, 0, 0x00060000, 21, 0x80000002, 0,
                0, 0,  0, 0,          0, 0, 0, 0,          0,  0,          0});
  EXPECT_EQ(errorOf(bytes),
            "in:byte 0: invalid Cap'n Proto message: Message contained out-of-bounds text pointer");
}

TEST(HostileMessages, SharedAndCyclicPointersFailQuickly) {
  // A level with a list of 2^28 parts. The structs have no words, so the claim takes no bytes.
  std::string bytes = little32({0, 10, 0, 0x00010001, 1, 0, 0, 0x00060000, 0, 0,          0,
                                0, 0,  0, 9,          7, 0, 0, 0,          0, 0x3ffffffc, 0});
  const std::clock_t start = std::clock();
  EXPECT_EQ(errorOf(bytes),
            "in:byte 0: invalid Cap'n Proto message: Exceeded message traversal limit");
  EXPECT_LT(double(std::clock() - start) / CLOCKS_PER_SEC, 0.5);
}

TEST(HostileMessages, BadValuesAreRefusedAsInJson) {
  test::RecordFiller filler(1, 1.0f, 2);
  RecordBuilder query;
  query.root().initQuery().setTimeLimit(8);
  std::string bytes;
  StreamWriter writer = StreamWriter::toBytes(Format::capnp, &bytes);
  ASSERT_TRUE(writer.write(query.reader()));
  const float eight = 8, bad = __builtin_inff();
  const size_t at = bytes.find(std::string(reinterpret_cast<const char*>(&eight), 4));
  ASSERT_NE(at, std::string::npos);
  std::memcpy(bytes.data() + at, &bad, 4);
  EXPECT_EQ(errorOf(bytes), "in:byte 0: timeLimit: expected a finite number, found inf");
}

TEST(HostileMessages, AnUnknownKindPassesThrough) {
  std::string bytes = message(3, Format::capnp, Kind::QUERY);
  // The discriminant follows the segment table and the root pointer.
  const size_t discriminant = 16;
  ASSERT_EQ(bytes[discriminant], char(uint16_t(Kind::QUERY)));
  bytes[discriminant] = 99;
  StreamReader reader = StreamReader::overBytes(bytes, "in");
  auto record = reader.next();
  ASSERT_TRUE(record && *record);
  EXPECT_FALSE((*record)->known());
  std::string out;
  StreamWriter writer = StreamWriter::toBytes(Format::capnp, &out);
  ASSERT_TRUE(writer.pass(**record));
  EXPECT_EQ(out, bytes);
}

}  // namespace
}  // namespace obby::io

// Tests the frame of a stream. Every truncated stream is an error, and every whole stream can be
// read.
#include <gtest/gtest.h>

#include "io/stream.h"
#include "io/version.h"
#include "random_record.h"

namespace obby::io {
namespace {

struct Read {
  uint64_t records = 0;
  std::string error;
};

Read readAll(const std::string& bytes) {
  StreamReader reader = StreamReader::overBytes(bytes, "in");
  Read out;
  for (;;) {
    auto record = reader.next();
    if (!record) {
      out.error = record.error().text();
      return out;
    }
    if (!*record) return out;
    out.records++;
  }
}

// Returns a stream of the header, one record of every other kind, and the end.
std::string framedStream(Format format) {
  std::string bytes;
  StreamWriter writer = StreamWriter::toBytes(format, &bytes);
  RecordBuilder header, end;
  auto first = header.root().initHeader();
  first.setSchemaMajor(kSchemaMajor);
  first.setTool("test");
  EXPECT_TRUE(writer.write(header.reader()));
  for (uint32_t kind = 1; kind + 1 < test::kKinds; kind++) {
    test::RecordFiller filler(kind, 0.7f, 2);
    EXPECT_TRUE(writer.write(filler.fill(Kind(kind)).reader()));
  }
  end.root().initEnd().setRecords(writer.recordsWritten());
  EXPECT_TRUE(writer.write(end.reader()));
  EXPECT_TRUE(writer.close());
  return bytes;
}

class EveryFormat : public testing::TestWithParam<Format> {};
INSTANTIATE_TEST_SUITE_P(Formats, EveryFormat,
                         testing::Values(Format::jsonl, Format::capnp, Format::capnpPacked));

TEST_P(EveryFormat, AWholeStreamIsRead) {
  const Read read = readAll(framedStream(GetParam()));
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.records, test::kKinds);
}

TEST_P(EveryFormat, EveryProperPrefixIsAnError) {
  const std::string whole = framedStream(GetParam());
  for (size_t n = 0; n < whole.size(); n++)
    ASSERT_NE(readAll(whole.substr(0, n)).error, "") << n << " of " << whole.size();
}

TEST_P(EveryFormat, ConcatenatedStreamsAreRead) {
  const std::string one = framedStream(GetParam());
  const Read read = readAll(one + one + one);
  EXPECT_EQ(read.error, "");
  EXPECT_EQ(read.records, 3 * test::kKinds);
}

TEST_P(EveryFormat, IsDetectedFromItsFirstBytes) {
  StreamReader reader = StreamReader::overBytes(framedStream(GetParam()), "in");
  ASSERT_TRUE(reader.next());
  EXPECT_EQ(reader.format(), GetParam());
}

TEST_P(EveryFormat, IsDetectedForAnyFirstRecord) {
  for (uint32_t i = 0; i < 300; i++) {
    test::RecordFiller filler(i, float(i % 10) / 9.0f, i % 6);
    const Kind kind = Kind(1 + i % (test::kKinds - 2));
    std::string bytes;
    StreamWriter writer = StreamWriter::toBytes(GetParam(), &bytes);
    ASSERT_TRUE(writer.write(filler.fill(kind).reader()));
    StreamReader reader = StreamReader::overBytes(bytes, "in");
    ASSERT_TRUE(reader.next());
    ASSERT_EQ(reader.format(), GetParam());
  }
}

struct Case {
  std::string bytes, error;
  uint64_t records;
};

TEST(Framing, Rules) {
  const std::string hint = " (convert a place file with obby-import, or make levels with obby-gen)";
  const std::string cut = " (the input was cut off; rerun the tool that wrote it)",
                    empty = "in: the input is empty (check the file, or the tool that writes it)";
  const std::string h = "{\"type\":\"header\"}\n", l = "{\"type\":\"level\"}\n",
                    e = "{\"type\":\"end\"}\n";
  const std::string line = "{\"type\":\"level\"}";
  const Case cases[] = {
      {"", empty, 0},
      {" \n\r\n\t", empty, 0},
      {l, "", 1},
      {line, "", 1},
      {"\n\n" + l + "\r\n \n" + l, "", 2},
      {"\xef\xbb\xbf" + l, "", 1},
      {"\xef\xbb\xbf\n" + l, "", 1},
      {h + l + e, "", 3},
      {l + h + l + e + l, "", 5},
      {h + e + h + e, "", 4},
      {l + e, "", 2},
      {h + l, "in: the stream ends without its end record" + cut, 2},
      {h + e + h, "in: the stream ends without its end record" + cut, 3},
      {h + l + h + e,
       "in:3: expected the end record of the stream that begins at line 1, found another header" +
           cut,
       2},
      {h + l + "{\"type\":\"end\"}", "in:3: the last line has no newline" + cut, 2},
      {h + l + "{\"type\":\"end\",\"records\":\"2\"}\n", "", 3},
      {h + l + l + "{\"type\":\"end\",\"records\":\"2\"}\n",
       "in:4: records: the end record counts 2 records, but the stream has 3 (the stream was cut "
       "or mixed with another; rerun the tool that wrote it)",
       3},
      {"{\"type\":\"header\",\"schemaMajor\":3,\"schemaMinor\":5}\n",
       "in:1: schemaMajor: the stream was written with schema 3.5, but this program (0.1.0) reads "
       "schema 2." +
           std::to_string(io::kSchemaMinor) + " (use tools of the same version)",
       0},
      {"<roblox!\x89\xff",
       "in: expected a stream of records, found a Roblox file (convert it with obby-import)", 0},
      {"\x1f\x8b\x08\x01zzzz",
       "in: expected a stream of records, found compressed data (decompress it first)", 0},
      {"hello world", "in: expected JSON lines or Cap'n Proto messages, found \"hello wo\"" + hint,
       0},
      {"part,x,y\n1,2,3\n",
       "in: expected JSON lines or Cap'n Proto messages, found \"part,x,y\"" + hint, 0},
      {"PK\x03\x04zzzzzzzz",
       "in: expected a stream of records, found compressed data (decompress it first)", 0},
      {"[1,2]",
       "in: expected one record per line, found a JSON array (write each element on its own line: "
       "jq -c "
       "'.[]' in)",
       0},
      {std::string("\xff\xd8\xff\xe0\0\x10JF", 8),
       "in: expected JSON lines or Cap'n Proto messages, found binary data" + hint, 0},
      {"{\n  \"type\": \"level\"\n}\n",
       "in:1: column 2: the text ends in the middle of a value; expected one record per line (join "
       "the lines of each record: jq -c . in)",
       0},
  };
  for (const Case& c : cases) {
    const Read read = readAll(c.bytes);
    EXPECT_EQ(read.error, c.error) << c.bytes;
    EXPECT_EQ(read.records, c.records) << c.bytes;
  }
}

TEST(Framing, ReadingContinuesAfterABadLineButNotAfterABrokenFrame) {
  StreamReader reader = StreamReader::overBytes(
      "{\"type\":\"header\"}\n{\"type\":3}\n{\"type\":\"level\"}\n"
      "{\"type\":\"end\",\"records\":\"3\"}\n{\"type\":\"end\"}\n{\"type\":\"header\"}\n",
      "in");
  EXPECT_TRUE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_TRUE(reader.canContinue());
  auto level = reader.next();
  ASSERT_TRUE(level && *level);
  EXPECT_EQ((*level)->which(), Kind::LEVEL);
  EXPECT_EQ((*level)->place(), "3");
  EXPECT_TRUE(reader.next());  // an unreadable line counts as a record
  EXPECT_TRUE(reader.next());
  EXPECT_TRUE(reader.next());
  EXPECT_FALSE(reader.next());
  EXPECT_FALSE(reader.canContinue());
  EXPECT_FALSE(reader.next());
}

TEST(Framing, EachStreamOfAnInputIsCountedOnItsOwn) {
  const std::string good =
      "{\"type\":\"header\"}\n{\"type\":\"x\"}\n{\"type\":\"end\",\"records\":\"2\"}\n";
  EXPECT_EQ(readAll(good + good).error, "");
}

}  // namespace
}  // namespace obby::io

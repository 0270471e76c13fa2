// Every kind of record survives both encodings: on every path the content and the bytes are equal.
#include <gtest/gtest.h>

#include "io/json_codec.h"
#include "io/pipeline.h"
#include "io/stream.h"
#include "random_record.h"

namespace obby::io {
namespace {

std::string written(schema::Record::Reader record, Format format) {
  std::string bytes;
  StreamWriter writer = StreamWriter::toBytes(format, &bytes);
  const Status status = writer.write(record);
  EXPECT_TRUE(status) << status.error().text();
  EXPECT_TRUE(writer.close());
  return bytes;
}

// Reads the records of `bytes` and writes them again.
std::string rewritten(const std::string& bytes, Format format) {
  std::string out;
  StreamWriter writer = StreamWriter::toBytes(format, &out);
  StreamReader reader = StreamReader::overBytes(bytes, "test");
  for (;;) {
    auto record = reader.next();
    EXPECT_TRUE(record) << record.error().text();
    if (!record || !*record) return out;
    EXPECT_TRUE(writer.write((*record)->reader()));
  }
}

void expectAllFormatsEqual(schema::Record::Reader record) {
  const std::string json = written(record, Format::jsonl);
  const std::string capnp = written(record, Format::capnp);
  const std::string packed = written(record, Format::capnpPacked);
  EXPECT_EQ(rewritten(json, Format::jsonl), json);
  EXPECT_EQ(rewritten(json, Format::capnp), capnp);
  EXPECT_EQ(rewritten(json, Format::capnpPacked), packed);
  EXPECT_EQ(rewritten(capnp, Format::jsonl), json);
  EXPECT_EQ(rewritten(capnp, Format::capnp), capnp);
  EXPECT_EQ(rewritten(packed, Format::jsonl), json);
  EXPECT_EQ(rewritten(packed, Format::capnp), capnp);
}

// Returns true for a header or end. A stream would refuse these alone, and the tests are about
// content.
bool isFrame(uint32_t kind) { return Kind(kind) == Kind::HEADER || Kind(kind) == Kind::END; }

TEST(RoundTrip, EveryKindWithEveryFieldSet) {
  for (uint32_t kind = 0; kind < test::kKinds; kind++) {
    test::RecordFiller filler(kind, 1.0f, 3);
    auto record = filler.fill(Kind(kind));
    if (isFrame(kind)) {
      const std::string json = written(record.reader(), Format::jsonl);
      auto back = recordFromJson(json.substr(0, json.size() - 1));
      ASSERT_TRUE(back) << back.error().text();
      EXPECT_EQ(written(back->reader(), Format::capnp), written(record.reader(), Format::capnp));
    } else {
      expectAllFormatsEqual(record.reader());
    }
  }
}

TEST(RoundTrip, RandomRecordsOfEveryKind) {
  for (uint32_t round = 0; round < 400; round++) {
    const uint32_t kind = round % test::kKinds;
    if (isFrame(kind)) continue;
    const float chances[] = {0.1f, 0.5f, 0.9f, 1.0f};
    test::RecordFiller filler(1000 + round, chances[round / 10 % 4], round % 7);
    expectAllFormatsEqual(filler.fill(Kind(kind)).reader());
  }
}

TEST(RoundTrip, AnEmptyRecordOfEveryKind) {
  for (uint32_t kind = 0; kind < test::kKinds; kind++) {
    test::RecordFiller filler(kind, 0.0f, 0);
    if (!isFrame(kind)) expectAllFormatsEqual(filler.fill(Kind(kind)).reader());
  }
}

TEST(RoundTrip, ValuesSpelledOutEqualValuesLeftOut) {
  auto full = recordFromJson(
      R"({"type":"query","id":"","maxJumps":-1,"waypoints":[],"goal":{"size":[4,4,4],"rotation":[0,0,0,1]}})");
  auto brief = recordFromJson(R"({"type":"query","goal":{}})");
  ASSERT_TRUE(full) << full.error().text();
  ASSERT_TRUE(brief);
  EXPECT_EQ(written(full->reader(), Format::capnp), written(brief->reader(), Format::capnp));
  EXPECT_EQ(written(full->reader(), Format::jsonl), "{\"type\":\"query\",\"goal\":{}}\n");
}

TEST(RoundTrip, TheOrderOfFillingABuilderDoesNotMatter) {
  RecordBuilder a, b;
  auto levelA = a.root().initLevel();
  levelA.setName("x");
  levelA.initParts(1)[0].initSize().setX(3);
  auto levelB = b.root().initLevel();
  auto part = levelB.initParts(1)[0];
  part.initTags(0);
  part.initRotation();
  part.initColor();
  part.initSize().setX(3);
  part.setName("");
  levelB.setName("x");
  EXPECT_EQ(written(a.reader(), Format::capnp), written(b.reader(), Format::capnp));
  EXPECT_EQ(written(a.reader(), Format::jsonl), written(b.reader(), Format::jsonl));
}

TEST(RoundTrip, PassKeepsTheBytesOfTheSameEncoding) {
  const std::string line = "{ \"type\" : \"level\", \"future\": [1, 2], \"name\": \"x\" }";
  StreamReader reader = StreamReader::overBytes(line + "\n", "test");
  auto record = reader.next();
  ASSERT_TRUE(record && *record);
  std::string same, other;
  StreamWriter sameWriter = StreamWriter::toBytes(Format::jsonl, &same);
  StreamWriter otherWriter = StreamWriter::toBytes(Format::capnp, &other);
  ASSERT_TRUE(sameWriter.pass(**record));
  ASSERT_TRUE(otherWriter.pass(**record));
  EXPECT_EQ(same, line + "\n");
  EXPECT_EQ(rewritten(other, Format::jsonl), "{\"type\":\"level\",\"name\":\"x\"}\n");
}

TEST(RoundTrip, UnknownKindsPassInTheirOwnEncodingOnly) {
  const std::string line = "{\"type\":\"weather\",\"rain\":true}\n";
  StreamReader reader = StreamReader::overBytes(line, "test");
  auto record = reader.next();
  ASSERT_TRUE(record && *record);
  EXPECT_FALSE((*record)->known());
  std::string same, other;
  StreamWriter sameWriter = StreamWriter::toBytes(Format::jsonl, &same);
  StreamWriter otherWriter = StreamWriter::toBytes(Format::capnp, &other);
  EXPECT_TRUE(sameWriter.pass(**record));
  EXPECT_FALSE(otherWriter.pass(**record));
  EXPECT_EQ(same, line);
  EXPECT_EQ(other, "");
}

}  // namespace
}  // namespace obby::io

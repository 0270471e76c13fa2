// Records that are encoded before they are written.
#include <gtest/gtest.h>

#include "io/stream.h"

namespace obby::io {
namespace {

RecordBuilder level(const char* name) {
  RecordBuilder builder;
  builder.root().initLevel().setName(name);
  return builder;
}

TEST(Encoded, GivesTheSameBytesAsWrite) {
  for (const Format made : {Format::jsonl, Format::capnp, Format::capnpPacked}) {
    for (const Format written : {Format::jsonl, Format::capnp, Format::capnpPacked}) {
      std::string ahead, plain;
      auto record = encoded(level("one"), made);
      ASSERT_TRUE(record);
      auto first = StreamWriter::toBytes(written, &ahead);
      ASSERT_TRUE(first.pass(*record));
      ASSERT_TRUE(first.close());
      auto second = StreamWriter::toBytes(written, &plain);
      ASSERT_TRUE(second.write(level("one").reader()));
      ASSERT_TRUE(second.close());
      EXPECT_EQ(ahead, plain) << int(made) << " to " << int(written);
      EXPECT_EQ(first.recordsWritten(), 1u);
    }
  }
}

TEST(Encoded, RefusesTheSameRecordsAsWrite) {
  RecordBuilder bad;
  bad.root().initLevel().setName("\xff");
  EXPECT_FALSE(encoded(std::move(bad), Format::jsonl));
}

TEST(StreamWriter, HandsRecordsToAFunction) {
  std::vector<std::string> names;
  auto writer = StreamWriter::toFunction([&](schema::Record::Reader record) -> Status {
    names.emplace_back(record.getLevel().getName());
    return names.size() < 3 ? Status() : makeError("enough");
  });
  EXPECT_TRUE(writer.write(level("one").reader()));
  EXPECT_TRUE(writer.pass(Record(level("two"))));
  auto other = StreamReader::overBytes("{\"type\":\"new\"}\n", "in");
  auto unknown = other.next();
  ASSERT_TRUE(unknown && *unknown);
  EXPECT_TRUE(writer.pass(**unknown)) << "no reader knows this record";
  EXPECT_EQ(writer.recordsWritten(), 2u);
  const Status refused = writer.write(level("three").reader());
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().message, "enough");
  EXPECT_EQ(names, (std::vector<std::string>{"one", "two", "three"}));
  EXPECT_EQ(writer.recordsWritten(), 2u);
  EXPECT_TRUE(writer.close());
}

}  // namespace
}  // namespace obby::io

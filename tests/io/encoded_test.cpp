// Records that are encoded ahead of their writing.
#include <gtest/gtest.h>

#include "io/stream.h"

namespace obby::io {
namespace {

RecordBuilder level(const char* name) {
  RecordBuilder builder;
  builder.root().initLevel().setName(name);
  return builder;
}

TEST(Encoded, GoesOutWithTheSameBytesAsWrite) {
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

TEST(Encoded, RefusesWhatWriteRefuses) {
  RecordBuilder bad;
  bad.root().initLevel().setName("\xff");
  EXPECT_FALSE(encoded(std::move(bad), Format::jsonl));
}

}  // namespace
}  // namespace obby::io

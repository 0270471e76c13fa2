// The metrics stream, whose reader may stall.
#include "train/run/metrics_stream.h"

#include <gtest/gtest.h>

#include "io/read_file.h"

namespace obby::train {
namespace {

// A stream to memory. Its reader takes records only while `takes` is set.
struct StreamToMemory {
  Result<MetricsStream> open() {
    return MetricsStream::open(
        {io::StreamWriter::toBytes(io::Format::jsonl, &bytes), [this](int) { return bool(takes); }},
        {"obby-test", "1", 5}, stop, late);
  }

  std::string bytes;
  std::atomic<bool> stop{false}, late{false}, takes{true};
};

const Metric kSolved[] = {{"solved", 0.5, ""}};

TEST(MetricsStream, HasAHeaderRecordsAndAnEnd) {
  StreamToMemory memory;
  auto stream = memory.open();
  ASSERT_TRUE(stream) << stream.error().text();
  EXPECT_EQ(memory.bytes.find(R"({"type":"header")"), 0u) << memory.bytes;
  ASSERT_TRUE(stream->write("test", 3, kSolved));
  EXPECT_TRUE(stream->finish({.skipped = 2, .errors = 2}));
  EXPECT_NE(memory.bytes.find(R"({"type":"metrics","source":"test","step":"3","values":)"
                              R"([{"name":"solved","value":0.5}]})"),
            std::string::npos)
      << memory.bytes;
  EXPECT_NE(memory.bytes.find(R"("status":"complete")"), std::string::npos) << memory.bytes;
  EXPECT_NE(memory.bytes.find(R"("skipped":"2")"), std::string::npos) << memory.bytes;
}

TEST(MetricsStream, ABudgetThatRanOutIsTheStatusOfItsEnd) {
  StreamToMemory memory;
  auto stream = memory.open();
  ASSERT_TRUE(stream);
  stream->outOfBudget();
  EXPECT_TRUE(stream->finish({}));
  EXPECT_NE(memory.bytes.find(R"("status":"budget")"), std::string::npos) << memory.bytes;
}

TEST(MetricsStream, OpeningDoesNotWaitForTheReader) {
  StreamToMemory memory;
  memory.takes = false;
  auto stream = memory.open();
  ASSERT_TRUE(stream) << stream.error().text();
  EXPECT_EQ(memory.bytes, "");
  EXPECT_FALSE(stream->readerTakesMore());
  memory.takes = true;
  ASSERT_TRUE(stream->write("test", 3, kSolved));
  EXPECT_EQ(memory.bytes.find(R"({"type":"header")"), 0u) << "before the first record";
}

TEST(MetricsStream, AStalledReaderIsGivenUpOnceItIsLate) {
  StreamToMemory memory;
  auto stream = memory.open();
  ASSERT_TRUE(stream);
  memory.takes = false;
  memory.late = true;
  const Status written = stream->write("test", 3, kSolved);
  ASSERT_FALSE(written);
  EXPECT_TRUE(io::isInterrupted(written.error()));
  EXPECT_EQ(written.error().input, "stdout");
  const Status finished = stream->finish({}, makeError("the work failed"));
  ASSERT_FALSE(finished);
  EXPECT_EQ(finished.error().message, "the work failed");
}

}  // namespace
}  // namespace obby::train

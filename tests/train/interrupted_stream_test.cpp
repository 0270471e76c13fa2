// A stream whose writer was interrupted lacks levels, so training does not repeat it.
#include "train/level_lines.h"
#include "train/stream_copy.h"

namespace obby::train {
namespace {

// Returns a stream with the end record that obby-gen writes after Ctrl-C or `timeout`.
std::string interruptedLines(uint64_t count, const std::vector<std::string>& more = {}) {
  std::string text = linesOf(count, more);
  const std::string complete = R"("complete")";
  return text.replace(text.rfind(complete), complete.size(), R"("interrupted")");
}

TEST(InterruptedStream, IsNotRepeated) {
  const LevelStream all(optionsOf(linesOf(3))), stream(optionsOf(interruptedLines(3)));
  for (const uint64_t index : {3, 4, 3}) {
    const auto none = stream.level(index, 1);
    ASSERT_FALSE(none) << index;
    EXPECT_EQ(none.error().text().find("levels:8: the tool that wrote this input was interrupted"),
              0u)
        << none.error().text();
    EXPECT_NE(none.error().text().find("--on-error skip"), std::string::npos);
  }
  for (uint64_t i = 0; i < 3; ++i) EXPECT_EQ(hashOf(stream, i), hashOf(all, i)) << i;
}

// The last turn lacks queries, so the stream does not number it.
TEST(InterruptedStream, HasAnIncompleteTurn) {
  const std::vector<std::string> easy(3, R"(,"difficulty":0.1)");
  const LevelStream stream(optionsOf(interruptedLines(3, easy)), {.choices = 2});
  EXPECT_NE(hashOf(stream, 0), 0u);
  EXPECT_FALSE(stream.level(1, 1));
}

TEST(InterruptedStream, IsRepeatedIfErrorsAreForgiven) {
  std::vector<std::string> errors, warned;
  io::SourceOptions options = optionsOf(interruptedLines(3));
  options.onError = io::OnError::skip;
  options.report = [&](const Error& error) { errors.push_back(error.text()); };
  options.warn = [&](const Error& error) { warned.push_back(error.text()); };
  const LevelStream all(optionsOf(linesOf(3))), stream(std::move(options));
  for (uint64_t i = 0; i < 9; ++i) EXPECT_EQ(hashOf(stream, i), hashOf(all, i % 3)) << i;
  EXPECT_TRUE(errors.empty());
  ASSERT_EQ(warned.size(), 1u);
  EXPECT_EQ(warned[0].find("levels:8: the tool that wrote this input was interrupted"), 0u)
      << warned[0];
  EXPECT_EQ(stream.summary().status, schema::EndStatus::INTERRUPTED);
}

TEST(InterruptedStream, IsEvaluatedUpToItsEnd) {
  const LevelStream once(optionsOf(interruptedLines(3)), {.again = false});
  const auto none = once.level(3, 1);
  ASSERT_TRUE(none) << none.error().text();
  EXPECT_EQ(*none, nullptr);
  EXPECT_EQ(once.summary().status, schema::EndStatus::INTERRUPTED);
}

TEST(InterruptedStream, IsNotCopiedForOtherRanks) {
  const std::atomic<bool> interrupted{false};
  Timeout timeout(interrupted, Timeout::kNone);
  const auto none = copyOfStream(optionsOf(interruptedLines(3)), timeout);
  ASSERT_FALSE(none);
  EXPECT_EQ(none.error().text().find("levels:8: the tool that wrote this input was interrupted"),
            0u)
      << none.error().text();
  io::SourceOptions options = optionsOf(interruptedLines(3));
  options.onError = io::OnError::skip;
  const auto copy = copyOfStream(std::move(options), timeout);
  ASSERT_TRUE(copy) << copy.error().text();
  const LevelStream all(optionsOf(linesOf(3)));
  const LevelStream copied(optionsOf(copy->records), {.before = copy->summary});
  for (uint64_t i = 0; i < 6; ++i) EXPECT_EQ(hashOf(copied, i), hashOf(all, i % 3)) << i;
  EXPECT_EQ(copied.summary().status, schema::EndStatus::INTERRUPTED);
}

// Ctrl-C reaches the writer of the stream and the reader. The stream may end, or break off, before
// the reader notices the signal.
TEST(InterruptedStream, EndsWithoutAnErrorAfterASignal) {
  for (const std::string& last : {interruptedLines(0), std::string(kHeaderLine)}) {
    SCOPED_TRACE(last);
    std::atomic<bool> interrupted{false};
    Timeout timeout(interrupted, Timeout::kNone);
    io::SourceOptions options;
    options.inputs = {"levels", "end"};
    options.stop = &timeout.stop();
    options.open = [&](const std::string& name) {
      interrupted = name == "end";
      return Result<io::StreamReader>(
          io::StreamReader::overBytes(interrupted ? last : linesOf(2), name));
    };
    const LevelStream stream(std::move(options), {.timeout = &timeout});
    const auto none = stream.level(2, 1);
    ASSERT_TRUE(none) << none.error().text();
    EXPECT_EQ(*none, nullptr) << "not the first level again";
    EXPECT_TRUE(bool(timeout.stop()));
    EXPECT_FALSE(timeout.expired());
    const LevelStream all(optionsOf(linesOf(2)));
    for (uint64_t i = 0; i < 2; ++i) EXPECT_EQ(hashOf(stream, i), hashOf(all, i)) << i;
  }
}

// The counts include records skipped by this tool and upstream.
TEST(LevelStream, SumsUpTheCountsOfItsRecords) {
  std::string text = linesOf(2);
  const std::string status = R"("status":"complete")";
  text.replace(text.rfind(status), status.size(),
               R"("status":"budget","skipped":"2","errors":"3")");
  text.insert(text.rfind(R"({"type":"end")"), R"({"type":"level","parts":7})"
                                              "\n");
  io::SourceOptions options = optionsOf(text);
  options.onError = io::OnError::skip;
  const LevelStream stream(std::move(options), {.before = {.skipped = 10, .errors = 20}});
  hashOf(stream, 0);
  EXPECT_EQ(stream.summary().errors, 20u) << "it is not there yet";
  hashOf(stream, 2);
  EXPECT_EQ(stream.summary().status, schema::EndStatus::BUDGET);
  EXPECT_EQ(stream.summary().skipped, 13u);
  EXPECT_EQ(stream.summary().errors, 24u);
}

}  // namespace
}  // namespace obby::train

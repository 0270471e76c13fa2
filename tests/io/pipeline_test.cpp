// The filter behind every tool.
#include "io/pipeline.h"

#include "pipeline_fixture.h"

namespace obby::io {
namespace {

using test::kHeader;
using test::passAll;
using Fixture = test::PipelineFixture;

TEST(Pipeline, ReplacesInputFramesByOneFrame) {
  Fixture f;
  f.input("{\"type\":\"header\"}\n{\"type\":\"level\"}\n{\"type\":\"end\",\"skipped\":\"2\"}\n");
  f.input("{\"type\":\"query\"}\n{\"type\":\"new\"}\n");
  ASSERT_TRUE(f.pipeline().runAndFinish(passAll));
  EXPECT_EQ(f.output,
            kHeader +
                "{\"type\":\"level\"}\n{\"type\":\"query\"}\n{\"type\":\"new\"}\n"
                "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"4\",\"skipped\":\"2\"}\n");
}

// The output declares the schema version of the records that pass through.
TEST(Pipeline, AStreamOfALaterSchemaStaysOne) {
  Fixture f;
  f.input(
      "{\"type\":\"header\",\"schemaMajor\":2,\"schemaMinor\":99}\n{\"type\":\"levle\"}\n{\"type\":"
      "\"end\"}\n");
  ASSERT_TRUE(f.pipeline().runAndFinish(passAll));
  const std::string once = f.output;
  EXPECT_NE(once.find("\"schemaMinor\":99"), std::string::npos);
  Fixture next;
  next.input(once);
  ASSERT_TRUE(next.pipeline().runAndFinish(passAll));
  EXPECT_EQ(next.output, once);
}

TEST(Pipeline, HandlersWriteBeforeTheRecordTheyPassOrDropIt) {
  Fixture f;
  f.input("{\"type\":\"query\",\"id\":\"a\"}\n{\"type\":\"query\",\"id\":\"b\"}\n");
  Pipeline pipeline = f.pipeline();
  ASSERT_TRUE(pipeline.runAndFinish([&](const Record& record) -> Result<Then> {
    RecordBuilder answer;
    answer.root().initResult().setQuery(record.reader().getQuery().getId());
    OBBY_RETURN_IF_ERROR(pipeline.write(answer.reader()));
    return record.reader().getQuery().getId() == "a" ? Then::pass : Then::drop;
  }));
  EXPECT_EQ(f.output, kHeader +
                          "{\"type\":\"result\",\"query\":\"a\",\"verdict\":\"solved\","
                          "\"solutions\":0,\"ticks\":0,\"jumps\":0}\n"
                          "{\"type\":\"query\",\"id\":\"a\"}\n"
                          "{\"type\":\"result\",\"query\":\"b\",\"verdict\":\"solved\","
                          "\"solutions\":0,\"ticks\":0,\"jumps\":0}\n"
                          "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"4\"}\n");
}

TEST(Pipeline, TheEndRecordIncludesOtherSourcesOfTheTool) {
  Fixture f;
  f.options.onError = OnError::skip;
  f.input("{\"type\":\"level\"}\n{\"type\":3}\n");
  for (const auto& [status, name] : {std::pair(schema::EndStatus::COMPLETE, "complete"),
                                     std::pair(schema::EndStatus::BUDGET, "budget"),
                                     std::pair(schema::EndStatus::INTERRUPTED, "interrupted"),
                                     std::pair(schema::EndStatus::FAILED, "failed")}) {
    f.output.clear();
    Pipeline pipeline = f.pipeline();
    ASSERT_TRUE(pipeline.run(passAll));
    pipeline.readElsewhere({status, 2, 4});
    ASSERT_TRUE(pipeline.finish());
    EXPECT_EQ(f.end(), std::string("{\"type\":\"end\",\"status\":\"") + name +
                           "\",\"records\":\"2\",\"skipped\":\"3\",\"errors\":\"5\"}\n");
  }
}

TEST(RecordSource, IsIncompleteAfterAnInterruptedEnd) {
  const std::string interrupted =
      "{\"type\":\"level\"}\n{\"type\":\"end\",\"status\":\"interrupted\"}\n";
  for (const OnError onError : {OnError::stop, OnError::skip}) {
    Fixture f;
    f.options.onError = onError;
    f.options.warn = [&](const Error& error) { f.reports.push_back(error.place); };
    f.input(interrupted);
    f.input("{\"type\":\"level\"}\n{\"type\":\"end\"}\n");
    RecordSource source(f.options);
    EXPECT_TRUE(source.checkWhole());
    for (auto record = source.next(); record && *record;) record = source.next();
    EXPECT_EQ(source.summary().status, schema::EndStatus::INTERRUPTED);
    const Status whole = source.checkWhole();
    if (onError == OnError::skip) {
      EXPECT_TRUE(whole);
      EXPECT_EQ(f.reports, std::vector<std::string>{"2"});
    } else {
      ASSERT_FALSE(whole);
      EXPECT_EQ(whole.error().input, f.options.inputs[0]);
      EXPECT_EQ(whole.error().place, "2");
      EXPECT_TRUE(f.reports.empty());
    }
  }
}

TEST(RecordSource, IsCompleteAfterAStop) {
  Fixture f;
  const std::atomic<bool> stop{true};
  f.options.stop = &stop;
  f.input("{\"type\":\"level\"}\n");
  RecordSource source(f.options);
  const auto none = source.next();
  ASSERT_TRUE(none && !*none);
  EXPECT_TRUE(source.checkWhole());
  EXPECT_EQ(source.summary().status, schema::EndStatus::COMPLETE);
  EXPECT_EQ(source.status(), schema::EndStatus::INTERRUPTED);
}

TEST(Pipeline, ABrokenFrameIsNeverForgiven) {
  Fixture f;
  f.options.onError = OnError::skip;
  f.input("{\"type\":\"header\"}\n{\"type\":\"level\"}\n");
  EXPECT_FALSE(f.pipeline().runAndFinish(passAll));
}

TEST(Pipeline, TheMostSevereStatusWins) {
  const std::string budget = "{\"type\":\"end\",\"status\":\"budget\"}\n",
                    interrupted = "{\"type\":\"end\",\"status\":\"interrupted\"}\n",
                    failed = "{\"type\":\"end\",\"status\":\"failed\"}\n",
                    complete = "{\"type\":\"level\"}\n{\"type\":\"end\"}\n";
  const auto statusOf = [](std::initializer_list<std::string> inputs, bool spent) {
    Fixture f;
    for (const auto& text : inputs) f.input(text);
    Pipeline pipeline = f.pipeline();
    if (spent) pipeline.outOfBudget();
    EXPECT_TRUE(pipeline.runAndFinish(passAll));
    for (const char* status : {"budget", "interrupted", "failed"})
      if (f.output.find(status) != std::string::npos) return std::string(status);
    return std::string("complete");
  };
  EXPECT_EQ(statusOf({complete, complete}, false), "complete");
  EXPECT_EQ(statusOf({complete}, true), "budget");
  EXPECT_EQ(statusOf({budget, complete}, false), "budget");
  EXPECT_EQ(statusOf({interrupted, budget}, true), "interrupted");
  EXPECT_EQ(statusOf({interrupted, failed, budget}, true), "failed");
}

TEST(Pipeline, AStopEndsTheStreamInOrder) {
  Fixture f;
  std::atomic<bool> stop{false};
  f.options.stop = &stop;
  f.input("{\"type\":\"level\"}\n{\"type\":\"level\"}\n");
  ASSERT_TRUE(f.pipeline().runAndFinish([&](const Record&) -> Result<Then> {
    stop = true;
    return Then::pass;
  }));
  EXPECT_EQ(f.output, kHeader +
                          "{\"type\":\"level\"}\n"
                          "{\"type\":\"end\",\"status\":\"interrupted\",\"records\":\"2\"}\n");
}

}  // namespace
}  // namespace obby::io

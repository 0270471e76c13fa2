// Tests how a pipeline handles its own errors, errors in records, and errors of the upstream tool.
#include "io/pipeline.h"

#include <capnp/serialize.h>

#include "pipeline_fixture.h"

namespace obby::io {
namespace {

using test::kHeader;
using test::passAll;
using Fixture = test::PipelineFixture;

TEST(Pipeline, AnErrorStopsTheRunAndKeepsEarlierOutput) {
  Fixture f;
  f.input("{\"type\":\"level\"}\n{\"type\":3}\n{\"type\":\"level\"}\n");
  const Status status = f.pipeline().runAndFinish(passAll);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().place, "2");
  EXPECT_EQ(f.output, kHeader +
                          "{\"type\":\"level\"}\n"
                          "{\"type\":\"end\",\"status\":\"failed\",\"records\":\"2\","
                          "\"errors\":\"1\"}\n");
}

TEST(Pipeline, AnErrorAtTheStartLeavesNoOutput) {
  Fixture f;
  f.options.inputs.push_back(f.folder / "missing");
  EXPECT_FALSE(f.pipeline().runAndFinish(passAll));
  EXPECT_EQ(f.output, "");
}

TEST(Pipeline, ForgivenErrorsAreReportedAndCounted) {
  for (OnError policy : {OnError::skip, OnError::emit}) {
    Fixture f;
    f.options.onError = policy;
    f.input("{\"type\":3}\n{\"type\":\"level\"}\n{\"type\":\"query\"}\n");
    ASSERT_TRUE(f.pipeline().runAndFinish([](const Record& record) -> Result<Then> {
      if (record.which() == Kind::QUERY) return makeError("bad query");
      return Then::pass;
    }));
    EXPECT_EQ(f.reports.size(), 2u);
    const bool emit = policy == OnError::emit;
    EXPECT_EQ(f.output, kHeader + (emit ? "{\"type\":3}\n" : "") + "{\"type\":\"level\"}\n" +
                            (emit ? "{\"type\":\"query\"}\n" : "") +
                            (emit ? "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"4\","
                                    "\"errors\":\"2\"}\n"
                                  : "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"2\","
                                    "\"skipped\":\"2\",\"errors\":\"2\"}\n"));
  }
}

// Unreadable records pass through unchanged, and so do queries of an unreadable level. The handler
// gets neither.
TEST(Pipeline, EmitPassesOnUnreadableRecords) {
  const std::string lines =
      "{oops\n {\"type\":\"level\",\"parts\":7}\r\n{\"type\":\"query\",\"id\":\"a\"}\n"
      "{\"type\":\"levle\"}\n{\"type\":\"level\"}\n";
  Fixture f;
  f.options.onError = OnError::emit;
  f.input(lines);
  size_t handled = 0;
  ASSERT_TRUE(f.pipeline().runAndFinish([&](const Record&) -> Result<Then> {
    handled++;
    return Then::pass;
  }));
  EXPECT_EQ(handled, 1u);
  EXPECT_EQ(f.reports.size(), 4u);
  EXPECT_EQ(f.output, kHeader + lines +
                          "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"6\","
                          "\"errors\":\"4\"}\n");
}

TEST(Pipeline, EmitPassesOnUnreadableMessages) {
  RecordBuilder bad;
  bad.root().initLevel().setName("\xff");  // no UTF-8
  const auto words = capnp::messageToFlatArray(bad.message());
  const std::string message(words.asChars().begin(), words.asChars().size());
  Fixture f;
  f.options.onError = OnError::emit;
  f.input(message);
  ASSERT_TRUE(f.pipeline(Format::capnp).runAndFinish(passAll));
  EXPECT_NE(f.output.find(message), std::string::npos);
  EXPECT_EQ(f.reports.size(), 1u);
}

TEST(Pipeline, EmitWarnsAboutRecordsThatTheOutputCannotHold) {
  Fixture f;
  f.options.onError = OnError::emit;
  std::vector<std::string> warnings;
  f.options.warn = [&](const Error& error) { warnings.push_back(error.text()); };
  f.input("{oops\n{\"type\":\"level\"}\n");
  ASSERT_TRUE(f.pipeline(Format::capnp).runAndFinish(passAll));
  EXPECT_EQ(f.reports.size(), 1u);
  EXPECT_EQ(warnings,
            std::vector<std::string>{f.options.inputs[0] +
                                     ":1: cannot convert this record: it could not be read (write "
                                     "the output in the format of the input: --format jsonl)"});
  EXPECT_EQ(f.end(),
            "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"2\",\"skipped\":\"1\","
            "\"errors\":\"1\"}\n");
}

// Under `stop` the error ends the run. Under `emit` the record is skipped, since the output cannot
// hold it.
TEST(Pipeline, ARecordThatTheOutputCannotHoldIsAnErrorAboutThatRecord) {
  for (OnError policy : {OnError::stop, OnError::skip, OnError::emit}) {
    Fixture f;
    f.options.onError = policy;
    f.input("{\"type\":\"level\"}\n{\"type\":\"weather\"}\n{\"type\":\"query\"}\n");
    const std::string where = f.options.inputs[0] + ":2";
    const Status status = f.pipeline(Format::capnp).runAndFinish(passAll);
    if (policy == OnError::stop) {
      ASSERT_FALSE(status);
      EXPECT_EQ(status.error().input + ":" + status.error().place, where);
      EXPECT_EQ(f.end(),
                "{\"type\":\"end\",\"status\":\"failed\",\"records\":\"2\",\"errors\":\"1\"}\n");
      continue;
    }
    ASSERT_TRUE(status);
    EXPECT_EQ(f.places, std::vector<std::string>{where});
    EXPECT_EQ(f.end(),
              "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"3\",\"skipped\":\"1\","
              "\"errors\":\"1\"}\n");
  }
}

// The record was already written, so it does not count as skipped. At that point the pipeline
// already reads the next input.
TEST(Pipeline, ALateErrorNamesTheRecordThatItIsAbout) {
  for (OnError policy : {OnError::stop, OnError::skip, OnError::emit}) {
    Fixture f;
    f.options.onError = policy;
    f.input("\n{\"type\":\"level\"}\n");
    f.input("{\"type\":\"query\"}\n");
    const std::string where = f.options.inputs[0] + ":2";
    std::optional<Record> level;
    Pipeline pipeline = f.pipeline();
    const Status status = pipeline.runAndFinish([&](const Record& record) -> Result<Then> {
      if (record.which() == Kind::LEVEL) level = record;
      if (record.which() != Kind::QUERY) return Then::pass;
      OBBY_RETURN_IF_ERROR(pipeline.forgiveLate(*level, makeError("no goal")));
      return Then::pass;
    });
    if (policy == OnError::stop) {
      ASSERT_FALSE(status);
      EXPECT_EQ(status.error().input + ":" + status.error().place, where);
      continue;
    }
    ASSERT_TRUE(status);
    EXPECT_EQ(f.places, std::vector<std::string>{where});
    EXPECT_EQ(f.end(),
              "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"3\",\"errors\":\"1\"}\n");
  }
}

TEST(Pipeline, AnErrorAfterTheRunIsInTheEndRecord) {
  Fixture f;
  f.input("{\"type\":\"level\"}\n");
  Pipeline pipeline = f.pipeline();
  ASSERT_TRUE(pipeline.run(passAll));
  const Status status = pipeline.finish(makeError("no query of that name"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "no query of that name");
  EXPECT_EQ(f.end(),
            "{\"type\":\"end\",\"status\":\"failed\",\"records\":\"2\",\"errors\":\"1\"}\n");
}

TEST(RecordSource, AMissingRecordIsAttributedToTheErrorThatEndedTheInput) {
  const Error missing = makeError("no query of that name");
  const auto said = [&](const std::string& status) {
    Fixture f;
    f.input("{\"type\":\"level\"}\n{\"type\":\"end\",\"status\":\"" + status + "\"}\n");
    RecordSource source(f.options);
    for (auto record = source.next(); record && *record;) record = source.next();
    const Error error = source.lacking(missing);
    return error.place + ": " + error.message;
  };
  EXPECT_EQ(said("complete"), ": no query of that name");
  EXPECT_EQ(said("budget"), ": no query of that name");
  EXPECT_EQ(said("interrupted"), "2: the tool that wrote this input was interrupted");
  EXPECT_EQ(said("failed"), "2: the tool that wrote this input stopped at an error");
}

TEST(Pipeline, AnUpstreamFailureIsReportedOnceAndPassedOn) {
  Fixture f;
  std::vector<std::string> warnings;
  f.options.warn = [&](const Error& error) { warnings.push_back(error.message); };
  const std::string failed = "{\"type\":\"level\"}\n{\"type\":\"end\",\"status\":\"failed\"}\n";
  f.input(failed);
  f.input(failed);
  ASSERT_TRUE(f.pipeline().runAndFinish(passAll));
  EXPECT_EQ(warnings,
            std::vector<std::string>{"the tool that wrote this input stopped at an error"});
  EXPECT_EQ(f.end(), "{\"type\":\"end\",\"status\":\"failed\",\"records\":\"3\"}\n");
  Pipeline again = f.pipeline();
  ASSERT_TRUE(again.run(passAll));
  EXPECT_FALSE(again.finish(again.source().lacking(makeError("no query"))));
  EXPECT_EQ(warnings.size(), 1u) << "the error says it";
}

TEST(Pipeline, AnErrorAfterAStopIsAnInterruption) {
  Fixture f;
  std::atomic<bool> stop{false};
  f.options.stop = &stop;
  f.input("{\"type\":\"level\"}\n");
  Pipeline pipeline = f.pipeline();
  ASSERT_TRUE(pipeline.run(passAll));
  stop = true;
  EXPECT_FALSE(pipeline.finish(makeError("interrupted")));
  EXPECT_EQ(f.end(),
            "{\"type\":\"end\",\"status\":\"interrupted\",\"records\":\"2\",\"errors\":\"1\"}\n");
}

}  // namespace
}  // namespace obby::io

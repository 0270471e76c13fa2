// The filter that every tool is.
#include "io/pipeline.h"

#include <gtest/gtest.h>

#include "scratch_folder.h"

namespace obby::io {
namespace {

using test::ScratchFolder;

struct Fixture {
  ScratchFolder folder;
  std::string output;
  std::vector<std::string> reports, places;
  SourceOptions options;

  Fixture() {
    options.inputs.clear();
    options.report = [this](const Error& error) {
      reports.push_back(error.message);
      places.push_back(error.input + ":" + error.place);
    };
  }
  void input(const std::string& text) {
    const std::string path = folder / std::to_string(options.inputs.size());
    std::ofstream(path) << text;
    options.inputs.push_back(path);
  }
  Pipeline pipeline(Format format = Format::jsonl) {
    return Pipeline(options, {"obby-test", "1.2.3", 42}, StreamWriter::toBytes(format, &output));
  }
  // The output's end record in JSON.
  std::string end() const {
    StreamReader reader = StreamReader::overBytes(output, "output");
    std::string line;
    for (auto record = reader.next(); record && *record; record = reader.next()) {
      if (!(*record)->known() || (*record)->which() != Kind::END) continue;
      StreamWriter writer = StreamWriter::toBytes(Format::jsonl, &line);
      EXPECT_TRUE(writer.write((*record)->reader()));
    }
    return line;
  }
};

const std::string kHeader =
    "{\"type\":\"header\",\"schemaMajor\":1,\"schemaMinor\":3,\"tool\":\"obby-test\",\"version\":"
    "\"1.2.3\",\"seed\":\"42\","
    "\"floatPolicy\":\"ieee754-nofma\"}\n";

Result<Then> passAll(const Record&) { return Then::pass; }

TEST(Pipeline, TakesFramesOffAndPutsOneOn) {
  Fixture f;
  f.input("{\"type\":\"header\"}\n{\"type\":\"level\"}\n{\"type\":\"end\",\"skipped\":\"2\"}\n");
  f.input("{\"type\":\"query\"}\n{\"type\":\"new\"}\n");
  ASSERT_TRUE(f.pipeline().runAndFinish(passAll));
  EXPECT_EQ(f.output,
            kHeader +
                "{\"type\":\"level\"}\n{\"type\":\"query\"}\n{\"type\":\"new\"}\n"
                "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"4\",\"skipped\":\"2\"}\n");
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

TEST(Pipeline, AnErrorStopsButKeepsWhatWasDone) {
  Fixture f;
  f.input("{\"type\":\"level\"}\n{\"type\":3}\n{\"type\":\"level\"}\n");
  const Status status = f.pipeline().runAndFinish(passAll);
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().place, "2");
  EXPECT_EQ(f.output, kHeader +
                          "{\"type\":\"level\"}\n"
                          "{\"type\":\"end\",\"status\":\"interrupted\",\"records\":\"2\","
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
    EXPECT_EQ(f.output, kHeader + "{\"type\":\"level\"}\n" +
                            (emit ? "{\"type\":\"query\"}\n" : "") +
                            (emit ? "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"3\","
                                    "\"skipped\":\"1\",\"errors\":\"2\"}\n"
                                  : "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"2\","
                                    "\"skipped\":\"2\",\"errors\":\"2\"}\n"));
  }
}

// Under stop it ends the run, under emit it cannot be passed on all the same.
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
                "{\"type\":\"end\",\"status\":\"interrupted\",\"records\":\"2\","
                "\"errors\":\"1\"}\n");
      continue;
    }
    ASSERT_TRUE(status);
    EXPECT_EQ(f.places, std::vector<std::string>{where});
    EXPECT_EQ(f.end(),
              "{\"type\":\"end\",\"status\":\"complete\",\"records\":\"3\",\"skipped\":\"1\","
              "\"errors\":\"1\"}\n");
  }
}

// It has gone out: nothing is left out on its account. The next input is being read by then.
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

TEST(Pipeline, AnErrorOfWorkAfterTheRunIsInTheEnd) {
  Fixture f;
  f.input("{\"type\":\"level\"}\n");
  Pipeline pipeline = f.pipeline();
  ASSERT_TRUE(pipeline.run(passAll));
  const Status status = pipeline.finish(makeError("no query of that name"));
  ASSERT_FALSE(status);
  EXPECT_EQ(status.error().message, "no query of that name");
  EXPECT_EQ(f.end(),
            "{\"type\":\"end\",\"status\":\"interrupted\",\"records\":\"2\",\"errors\":\"1\"}\n");
}

TEST(Pipeline, WhatCameOfOtherSourcesOfAToolIsInTheEnd) {
  Fixture f;
  f.options.onError = OnError::skip;
  f.input("{\"type\":\"level\"}\n{\"type\":3}\n");
  for (const auto& [status, name] : {std::pair(schema::EndStatus::COMPLETE, "complete"),
                                     std::pair(schema::EndStatus::BUDGET, "budget"),
                                     std::pair(schema::EndStatus::INTERRUPTED, "interrupted")}) {
    f.output.clear();
    Pipeline pipeline = f.pipeline();
    ASSERT_TRUE(pipeline.run(passAll));
    pipeline.readElsewhere({status, 2, 4});
    ASSERT_TRUE(pipeline.finish());
    EXPECT_EQ(f.end(), std::string("{\"type\":\"end\",\"status\":\"") + name +
                           "\",\"records\":\"2\",\"skipped\":\"3\",\"errors\":\"5\"}\n");
  }
}

TEST(RecordSource, IsNotWholeWhereAnEndSaysItWasInterrupted) {
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

TEST(RecordSource, IsWholeWhereItWasOnlyToldToStop) {
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

TEST(Pipeline, TheGravestStatusWins) {
  const std::string budget = "{\"type\":\"end\",\"status\":\"budget\"}\n",
                    interrupted = "{\"type\":\"end\",\"status\":\"interrupted\"}\n",
                    complete = "{\"type\":\"level\"}\n{\"type\":\"end\"}\n";
  const auto statusOf = [](std::initializer_list<std::string> inputs, bool spent) {
    Fixture f;
    for (const auto& text : inputs) f.input(text);
    Pipeline pipeline = f.pipeline();
    if (spent) pipeline.outOfBudget();
    EXPECT_TRUE(pipeline.runAndFinish(passAll));
    for (const char* status : {"budget", "interrupted"})
      if (f.output.find(status) != std::string::npos) return std::string(status);
    return std::string("complete");
  };
  EXPECT_EQ(statusOf({complete, complete}, false), "complete");
  EXPECT_EQ(statusOf({complete}, true), "budget");
  EXPECT_EQ(statusOf({budget, complete}, false), "budget");
  EXPECT_EQ(statusOf({interrupted, budget}, true), "interrupted");
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

// A record that names no level belongs to the level before it. If that level was unreadable, the
// record is dropped.
#include "io/lost_level.h"

#include <capnp/serialize.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/pipeline.h"

namespace obby::io {
namespace {

const std::string kLevel = "{\"type\":\"level\",\"name\":\"A\"}\n";
const std::string kLost = "{\"type\":\"level\",\"parts\":7}\n";

std::string query(const std::string& id, const std::string& level = "") {
  const std::string named = level.empty() ? "" : ",\"level\":\"" + level + "\"";
  return "{\"type\":\"query\",\"id\":\"" + id + "\"" + named + "}\n";
}

// Reads these texts as inputs. An empty text stands for an input that cannot be opened. `came`
// lists the ids of queries, and "+" for each level.
struct LostLevelRead {
  std::string came;
  std::vector<std::string> reports;
  SourceSummary summary;

  explicit LostLevelRead(std::vector<std::string> inputs, OnError onError = OnError::skip) {
    SourceOptions options;
    options.onError = onError;
    options.report = [this](const Error& error) { reports.push_back(error.text()); };
    options.inputs.clear();
    for (size_t i = 0; i < inputs.size(); ++i) options.inputs.push_back(std::to_string(i));
    options.open = [&inputs](const std::string& name) {
      const std::string& text = inputs[std::stoul(name)];
      if (text.empty()) return Result<StreamReader>(Error{"in" + name, {}, {}, "broken", {}});
      return Result<StreamReader>(StreamReader::overBytes(text, "in" + name));
    };
    RecordSource source(options);
    for (auto record = source.next(); record && *record; record = source.next()) {
      if (!(*record)->known()) continue;
      if ((*record)->which() == Kind::LEVEL) came += "+";
      if ((*record)->which() == Kind::QUERY) came += (*record)->reader().getQuery().getId().cStr();
      if ((*record)->which() == Kind::TRAJECTORY) came += "t";
    }
    summary = source.summary();
  }
};

TEST(LostLevel, DropsQueriesThatNameNoLevel) {
  const std::string text =
      kLevel + query("a") + kLost + query("b") + query("c", "A") + query("d") + kLevel + query("e");
  for (const OnError onError : {OnError::skip, OnError::emit}) {
    const LostLevelRead read({text}, onError);
    EXPECT_EQ(read.came, "+ac+e");
    ASSERT_EQ(read.reports.size(), 3u);
    EXPECT_EQ(read.reports[1],
              "in0:4: level: this record names no level, and the record at in0:3, which may be its "
              "level, could "
              "not be read (fix that record, or name the level in this one)");
    EXPECT_EQ(read.reports[2].find("in0:6: level: "), 0u) << read.reports[2];
    EXPECT_EQ(read.summary.skipped, 3u);
    EXPECT_EQ(read.summary.errors, 3u);
  }
}

TEST(LostLevel, KeepsRecordsOfOtherLevels) {
  // The unreadable record is known to be a query.
  EXPECT_EQ(LostLevelRead({kLevel + "{\"type\":\"query\",\"id\":7}\n" + query("b")}).came, "+b");
  // Later versions of the schema may define this kind of record.
  EXPECT_EQ(LostLevelRead({kLevel + "{\"type\":\"weather\"}\n" + query("b")}).came, "+b");
  EXPECT_EQ(LostLevelRead({kLost + kLevel + query("b")}).came, "+b");
}

TEST(LostLevel, IsAnyRecordOfUnreadableKind) {
  for (const char* lost :
       {"{\"name\":\"B\",\"type\" : \"level\",\"parts\":[", "{\"type\":\"levle\"}", "{\"type\":3}",
        "B", "{\"type\":\"query\",\"type\":\"level\"}"}) {
    EXPECT_EQ(LostLevelRead({kLevel + query("a") + lost + "\n" + query("b")}).came, "+a") << lost;
  }
}

TEST(LostLevel, DropsTrajectoriesToo) {
  const std::string trajectory = "{\"type\":\"trajectory\",\"query\":\"b\",\"outcome\":\"goal\"}\n";
  EXPECT_EQ(LostLevelRead({kLevel + trajectory + kLost + query("b") + trajectory}).came, "+t");
}

TEST(LostLevel, AppliesToLaterInputs) {
  const std::string end = "{\"type\":\"end\"}\n";
  for (const std::string& last : {kLost, kLost + end}) {
    const LostLevelRead read({kLevel + last, query("b") + query("c", "A"), kLevel + query("d")});
    EXPECT_EQ(read.came, "+c+d");
    EXPECT_EQ(read.reports[1].find("in1:1: level: "), 0u) << read.reports[1];
    EXPECT_NE(read.reports[1].find(" at in0:2, "), std::string::npos) << read.reports[1];
  }
}

// An unreadable query at the end of an input does not count as a lost level.
TEST(LostLevel, AnUnreadableLastQueryIsNoLostLevel) {
  const std::string lostQuery = "{\"type\":\"query\",\"id\":7}\n";
  EXPECT_EQ(LostLevelRead({kLevel + lostQuery, query("b")}).came, "+b");
  EXPECT_EQ(LostLevelRead({kLost + lostQuery, query("b")}).came, "");
}

TEST(LostLevel, MayBeInAnInputThatCannotBeOpened) {
  const LostLevelRead read({kLevel, "", query("b") + query("c", "A")});
  EXPECT_EQ(read.came, "+c");
  ASSERT_EQ(read.reports.size(), 2u);
  EXPECT_NE(read.reports[1].find(" at in1, "), std::string::npos) << read.reports[1];
}

TEST(LostLevel, IsRecognisedInMessages) {
  std::string bytes;
  RecordBuilder level, bad, asked, lostQuery;
  level.root().initLevel();
  bad.root().initLevel().setName("\xff");  // no UTF-8
  asked.root().initQuery().setId("a");
  lostQuery.root().initQuery().setId("\xff");
  const auto append = [&](RecordBuilder& record) {
    const auto words = capnp::messageToFlatArray(record.message());
    const auto chars = words.asChars();
    bytes.append(chars.begin(), chars.size());
  };
  for (RecordBuilder* record : {&level, &asked, &lostQuery, &asked, &bad, &asked}) append(*record);
  const LostLevelRead read({bytes});
  EXPECT_EQ(read.came, "+aa");
  EXPECT_EQ(read.reports.size(), 3u);
}

}  // namespace
}  // namespace obby::io

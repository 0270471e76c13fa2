// Streams of levels with a query each, as text and as a LevelStream reads them.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "train/level_stream.h"

namespace obby::train {

inline constexpr const char* kHeaderLine = R"({"type":"header","schemaVersion":1})"
                                           "\n";

// Returns a level and its query. Each level has a floor of a different width, and therefore a
// different hash.
inline std::string lineOf(uint64_t number, const std::string& more = "") {
  return fmt::format(
      R"({{"type":"level","name":"{0}","parts":[{{"shape":"block",)"
      R"("position":[0,-0.5,0],"size":[{1},1,40]}}]}})"
      "\n"
      R"({{"type":"query","id":"q","level":"{0}","start":{{"region":{{"position":[0,2.5,0],"size":[4,5,4]}}}},)"
      R"("goal":{{"position":[0,2,-12],"size":[4,4,4]}}{2}}})"
      "\n",
      number, 8 + number, more);
}

// Returns a stream of `count` levels. `more` holds additional fields of the first queries.
inline std::string linesOf(uint64_t count, const std::vector<std::string>& more = {}) {
  std::string text = kHeaderLine;
  for (uint64_t i = 0; i < count; ++i) text += lineOf(i, i < more.size() ? more[i] : "");
  return text + R"({"type":"end","status":"complete"})" + "\n";
}

inline io::SourceOptions optionsOf(std::string text) {
  io::SourceOptions options;
  options.open = [text = std::move(text)](const std::string&) {
    return Result<io::StreamReader>(io::StreamReader::overBytes(text, "levels"));
  };
  return options;
}

inline uint64_t hashOf(const LevelStream& stream, uint64_t index) {
  const auto level = stream.level(index, 1);
  EXPECT_TRUE(level) << (level ? "" : level.error().text());
  return level ? (*level)->hash() : 0;
}

}  // namespace obby::train

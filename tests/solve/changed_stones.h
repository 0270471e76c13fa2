// The stepping stones, and a version with a fourth stone, which is the goal. An answer for the
// first version does not solve the second.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "solve/answer/earlier_answers.h"
#include "solve/scenes.h"

namespace obby::solve {

// Reads a stream's answers.
inline EarlierAnswers answersIn(const std::string& text) {
  const LinesFile file(text);
  io::SourceOptions source;
  source.inputs = {file.path()};
  auto answers = EarlierAnswers::read(std::move(source));
  EXPECT_TRUE(answers) << answers.error().text();
  return *std::move(answers);
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos);
  return text.replace(at, from.size(), to);
}

inline std::string fourStones() {
  std::string text =
      replaced(stonesText(), "\"goal\":{}}]",
               R"("goal":{}},{"name":"D","position":[12,-0.5,-28],"size":[8,1,8]}])");
  return replaced(text, "\"position\":[0,2,-28]", "\"position\":[12,2,-28]");
}

}  // namespace obby::solve

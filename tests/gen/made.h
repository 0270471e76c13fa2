// Generated levels for tests.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "gen/generator.h"
#include "gen/styles.h"
#include "io/stream.h"

namespace obby::test {

inline gen::Generator generatorOf(const gen::Recipe& recipe, bool unsolvable = false) {
  auto generator = gen::Generator::make(recipe, unsolvable);
  EXPECT_TRUE(generator) << generator.error().text();
  return *std::move(generator);
}

inline gen::Recipe recipeFor(const std::string& style, float difficulty) {
  gen::Recipe recipe;
  recipe.styles = {{style, 1}};
  recipe.difficulty = {difficulty, difficulty};
  return recipe;
}

// Returns a recipe that sets every parameter of every style at random within its range.
inline gen::Recipe anyParametersFor(const std::string& style, float difficulty, uint64_t seed) {
  gen::Recipe recipe = recipeFor(style, difficulty);
  Random random(seed, 0x706172616d);
  for (const gen::Style& s : gen::styles()) {
    for (const gen::Parameter& p : s.parameters) {
      const float easy = p.min + (p.max - p.min) * random.unit();
      const float hard = p.min + (p.max - p.min) * random.unit();
      recipe.parameters.push_back({&p, easy, hard});
    }
  }
  return recipe;
}

// A level and its query as records.
struct Made {
  io::RecordBuilder level, query;
};

inline Made makeRecords(const gen::Generator& generator, uint64_t seed, uint64_t index) {
  Made made;
  const gen::Generated from = generator.generate(seed, index);
  generator.writeLevel(from, made.level.root().initLevel());
  gen::Generator::writeQuery(from, made.query.root().initQuery());
  return made;
}

inline std::string bytesOf(const Made& made, io::Format format = io::Format::jsonl) {
  std::string bytes;
  auto writer = io::StreamWriter::toBytes(format, &bytes);
  EXPECT_TRUE(writer.write(made.level.reader()));
  EXPECT_TRUE(writer.write(made.query.reader()));
  EXPECT_TRUE(writer.close());
  return bytes;
}

inline std::vector<std::string> styleNames() {
  std::vector<std::string> names;
  for (const gen::Style& s : gen::styles()) names.emplace_back(s.name);
  return names;
}

// Returns the name without dashes, which test names must not contain.
inline std::string testName(const ::testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  for (char& c : name) c = c == '-' ? '_' : c;
  return name;
}

}  // namespace obby::test

// What levels to make: styles with weights, difficulty, lengths, shares of queries with limits.
// From a small JSON file (docs/generator.md) or set in code. Generator::make checks it
// (recipe_check.h).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "level/params.h"

namespace obby::gen {

struct Range {
  float lo, hi;
};

struct Count {
  uint32_t lo, hi;
};

struct NamedNumber {
  std::string name;
  float value;
};

// Easiest first: trivial, easy, medium, hard, limit.
const std::vector<NamedNumber>& namedDifficulties();
// The name that is nearest.
const std::string& nameOfDifficulty(float value);
// "hard", "0.6". Error: neither.
Result<float> parseDifficulty(std::string_view text);

struct Parameter;

// Other ends for a parameter of a style (lib/gen/style.h): at difficulty 0 and 1.
struct Setting {
  const Parameter* parameter;  // of a style of the table
  float easy, hard;
};

struct Recipe {
  std::vector<NamedNumber> styles;        // with weights; empty: every style alike
  Range difficulty{0.25f, 0.75f};         // 0 to 1; drawn anew for each level
  Count obstacles{1, 3};                  // of a level of one style
  Count courseObstacles{3, 5};            // of a course
  std::vector<NamedNumber> courseStyles;  // that courses are made of; empty: every style alike
  float courseFirst = 0.4f;               // share of its difficulty that a course begins with
  float turns = 0.5f;                     // share of landings behind which the way turns
  float waypoints = 0, jumpLimits = 0, timeLimits = 0;  // shares of queries with such a constraint
  Range excess{5, 8};                                   // studs beyond reach, of what is unsolvable
  std::vector<Setting> parameters;                      // each at most once
  std::vector<NamedNumber> physics;  // fields of PhysicsParams that differ from their defaults

  // A JSON object. Errors name the path, what was expected, and what there is instead.
  static Result<Recipe> fromJson(std::string_view text);
};

}  // namespace obby::gen

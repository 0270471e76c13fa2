// Parameters of level generation: style weights, difficulty, lengths, and shares of queries with
// limits. A recipe comes from a small JSON file (docs/generator.md) or from code. Generator::make
// checks it.
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

// The named difficulties, easiest first: trivial, easy, medium, hard, limit.
const std::vector<NamedNumber>& namedDifficulties();
// Returns the name nearest to a value.
const std::string& nameOfDifficulty(float value);
// Parses "hard" or "0.6". Errors: any other text.
Result<float> parseDifficulty(std::string_view text);

struct Parameter;

// New values of a style's parameter (lib/gen/style.h) at difficulty 0 and 1.
struct Setting {
  const Parameter* parameter;  // belongs to a style in the table
  float easy, hard;
};

struct Recipe {
  std::vector<NamedNumber> styles;        // weights; empty: all styles equally
  Range difficulty{0.25f, 0.75f};         // 0 to 1; drawn for each level
  Count obstacles{1, 3};                  // obstacles in a level of one style
  Count courseObstacles{3, 5};            // obstacles in a course
  std::vector<NamedNumber> courseStyles;  // weights of the styles in courses; empty: all equally
  float courseFirst = 0.4f;               // a course begins at this share of its difficulty
  float turns = 0.5f;                     // share of landings after which the route turns
  // Shares of queries with waypoints, jump limits and time limits.
  float waypoints = 0, jumpLimits = 0, timeLimits = 0;
  Range excess{5, 8};                // studs by which an impossible crossing is
                                     // out of reach
  std::vector<Setting> parameters;   // each parameter at most once
  std::vector<NamedNumber> physics;  // changed fields of PhysicsParams

  // Parses a JSON object. Errors name the path, the expected value and the one found.
  static Result<Recipe> fromJson(std::string_view text);
};

// Error: unknown names, ranges whose ends are in the wrong order, numbers out of bounds.
Status checkRecipe(const Recipe& recipe);

}  // namespace obby::gen

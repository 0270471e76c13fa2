// Levels with a query each, as many as anyone asks for. Level `index` of a seed is the same
// whatever else is generated, on every machine and thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "gen/recipe.h"
#include "gen/sketch.h"
#include "schema/obby.capnp.h"

namespace obby::gen {

// The constraints that a query of such a level has, beside start and goal.
struct Limits {
  std::vector<uint32_t> waypoints;  // stops, in order
  uint32_t maxJumps = 0;            // 0: none
  float timeLimit = 0;              // seconds; 0: none
};

// One level and its query, not yet written as records. Its generator must outlive it.
struct Generated {
  std::string name;   // of the level: style, difficulty, seed, index; of a twin, what is planted
  std::string query;  // id of the query
  float difficulty;   // 0 to 1, as drawn
  Sketch sketch;
  Limits limits;
};

class Generator {
 public:
  // `unsolvable`: of every level the twin in which one crossing is beyond reach. Errors as of
  // checkRecipe(), and those of physics parameters.
  static Result<Generator> make(const Recipe& recipe, bool unsolvable);

  // Pure, and safe to call from several threads.
  Generated generate(uint64_t seed, uint64_t index) const;

  void writeLevel(const Generated& from, schema::Level::Builder to) const;
  static void writeQuery(const Generated& from, schema::Query::Builder to);

  const Reach& reach() const { return reach_; }
  bool unsolvable() const { return unsolvable_; }

 private:
  Generator(Recipe recipe, const Params& params, bool unsolvable);

  struct Choice {
    const struct Style* style;
    float until;  // sum of the weights so far
  };
  static std::vector<Choice> choices(const std::vector<NamedNumber>& weights, bool inCourses);
  // Does it spread to the sides, by its kind or by what the recipe makes of it? No turn beside it.
  bool spreads(const struct Style& style) const;
  static const struct Style& pick(const std::vector<Choice>& from, float unit);
  Sketch draw(const struct Style& style, float difficulty, const Random& random,
              const SketchPlan& plan) const;
  // Of a course: which styles it is made of.
  void pickChain(Sketch& s, std::vector<const struct Style*>& chain) const;
  Limits limits(const Sketch& sketch, Random& random) const;

  Recipe recipe_;
  Reach reach_;
  bool unsolvable_;
  std::vector<Choice> styles_, courseStyles_;
};

}  // namespace obby::gen

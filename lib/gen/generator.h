// Generates levels with one query each. Level `index` of a seed does not depend on other levels,
// the machine or the thread.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "base/result.h"
#include "gen/recipe.h"
#include "gen/sketch.h"
#include "schema/obby.capnp.h"

namespace obby::gen {

// The constraints of a level's query in addition to start and goal.
struct Limits {
  std::vector<uint32_t> waypoints;  // stop indices, in order
  uint32_t maxJumps = 0;            // 0: none
  float timeLimit = 0;              // seconds; 0: none
};

// A level and its query, before they are written as records. The generator must outlive this
// object.
struct Generated {
  std::string name;   // style, difficulty, seed and index; for an unsolvable twin also its
                      // impossible crossing
  std::string query;  // id of the query
  float difficulty;   // 0 to 1
  Sketch sketch;
  Limits limits;
};

class Generator {
 public:
  // `unsolvable`: generates the unsolvable twin of each level, in which one crossing is out of
  // reach. Errors: those of checkRecipe() and setPhysics().
  static Result<Generator> make(const Recipe& recipe, bool unsolvable);

  // Pure and thread-safe.
  Generated generate(uint64_t seed, uint64_t index) const;

  void writeLevel(const Generated& from, schema::Level::Builder to) const;
  static void writeQuery(const Generated& from, schema::Query::Builder to);

  const Reach& reach() const { return reach_; }
  bool unsolvable() const { return unsolvable_; }

 private:
  Generator(Recipe recipe, const Params& params, bool unsolvable);

  struct Choice {
    const struct Style* style;
    float until;  // sum of the weights up to and including this style
  };
  static std::vector<Choice> choices(const std::vector<NamedNumber>& weights, bool inCourses);
  // Returns true if the style extends to the sides, by itself or by the recipe's parameters. The
  // route does not turn next to it.
  bool spreads(const struct Style& style) const;
  static const struct Style& pick(const std::vector<Choice>& from, float unit);
  Sketch draw(const struct Style& style, float difficulty, const Random& random,
              const SketchPlan& plan) const;
  // Picks the styles of a course.
  void pickChain(Sketch& s, std::vector<const struct Style*>& chain) const;
  Limits limits(const Sketch& sketch, Random& random) const;

  Recipe recipe_;
  Reach reach_;
  bool unsolvable_;
  std::vector<Choice> styles_, courseStyles_;
};

}  // namespace obby::gen

#include "gen/generator.h"

#include <algorithm>

#include "gen/physics.h"
#include "gen/styles.h"

namespace obby::gen {

namespace {

// Numbers of further random streams. The level's own stream has the level's index as its number.
constexpr uint64_t kLimitStream = uint64_t(1) << 62, kPlantStream = uint64_t(2) << 62;
// Slack of the time limits: a factor of a steady player's time, and extra seconds.
constexpr float kTimeSlack = 2.5f, kTimeExtra = 5;
constexpr uint32_t kJumpSlack = 2, kJumpExtra = 3;

}  // namespace

Generator::Generator(Recipe recipe, const Params& params, bool unsolvable)
    : recipe_(std::move(recipe)),
      reach_(params),
      unsolvable_(unsolvable),
      styles_(choices(recipe_.styles, false)),
      courseStyles_(choices(recipe_.courseStyles, true)) {}

Result<Generator> Generator::make(const Recipe& recipe, bool unsolvable) {
  OBBY_RETURN_IF_ERROR(checkRecipe(recipe));
  OBBY_ASSIGN(const Params params, paramsOf(recipe.physics));
  if (unsolvable && Reach(params).cut()) {
    return makeError("with these physics parameters, players jump too far for an unsolvable level",
                     "raise gravity, or lower walkSpeed or jumpSpeed");
  }
  return Generator(recipe, params, unsolvable);
}

std::vector<Generator::Choice> Generator::choices(const std::vector<NamedNumber>& weights,
                                                  bool inCourses) {
  std::vector<Choice> out;
  float sum = 0;
  for (const Style& style : styles()) {
    if (inCourses && style.chains) continue;
    float weight = weights.empty() ? 1.0f : 0.0f;
    for (const NamedNumber& w : weights) {
      if (w.name == style.name) weight = w.value;
    }
    if (weight > 0) out.push_back({&style, sum += weight});
  }
  return out;
}

const Style& Generator::pick(const std::vector<Choice>& from, float unit) {
  const float at = unit * from.back().until;
  for (const Choice& c : from) {
    if (at < c.until) return *c.style;
  }
  return *from.back().style;
}

// Obstacles of at most their default sizes keep the parts behind a turn out of jumping range.
// Larger ones may not.
bool Generator::spreads(const Style& style) const {
  return style.wide || std::ranges::any_of(recipe_.parameters, [&](const Setting& s) {
           const bool own = s.parameter >= style.parameters.data() &&
                            s.parameter < style.parameters.data() + style.parameters.size();
           return own && maxf(s.easy, s.hard) > maxf(s.parameter->easy, s.parameter->hard);
         });
}

void Generator::pickChain(Sketch& s, std::vector<const Style*>& chain) const {
  std::vector<const Style*> used;
  for (const Style*& one : chain) {
    one = &pick(courseStyles_, s.unit());
    const bool again = std::find(used.begin(), used.end(), one) != used.end();
    if (one->single && again) one = &styles().front();
    used.push_back(one);
  }
}

Sketch Generator::draw(const Style& style, float difficulty, const Random& random,
                       const SketchPlan& plan) const {
  Sketch s(reach_, recipe_, random, plan);
  s.start();
  uint32_t obstacles = s.count(style.chains ? recipe_.courseObstacles : recipe_.obstacles);
  if (style.single) obstacles = 1;
  std::vector<const Style*> chain(obstacles, &style);
  if (style.chains) pickChain(s, chain);
  for (uint32_t i = 0; i < obstacles; ++i) {
    const float progress = obstacles > 1 ? float(i) / float(obstacles - 1) : 1.0f;
    const float first = style.chains ? recipe_.courseFirst : 1.0f;
    s.begin(difficulty * (first + (1 - first) * progress));
    chain[i]->build(s);
    const bool last = i + 1 == obstacles;
    s.rest(last, !spreads(*chain[i]) && (last || !spreads(*chain[i + 1])));
  }
  return s;
}

Limits Generator::limits(const Sketch& sketch, Random& random) const {
  Limits out;
  const bool passes = random.unit() < recipe_.waypoints;
  for (uint32_t i = 1; i + 1 < sketch.stops().size() && passes; ++i) {
    if (random.below(2) == 0) out.waypoints.push_back(i);
  }
  if (random.unit() < recipe_.jumpLimits) out.maxJumps = kJumpSlack * sketch.jumps() + kJumpExtra;
  if (random.unit() < recipe_.timeLimits) {
    out.timeLimit = float(int32_t(kTimeSlack * sketch.seconds() + kTimeExtra));
  }
  return out;
}

Generated Generator::generate(uint64_t seed, uint64_t index) const {
  Random random(seed, index);
  const Style& style = pick(styles_, random.unit());
  const Range d = recipe_.difficulty;
  const float difficulty = d.lo + (d.hi - d.lo) * random.unit();
  Sketch sketch = draw(style, difficulty, random, {});
  std::string name = std::string(style.name) + '-' + nameOfDifficulty(difficulty) + '-' +
                     std::to_string(seed) + '-' + std::to_string(index);
  std::string query = "to-the-goal";
  // An unsolvable twin has the limits of its solvable level.
  Random limit(seed, index ^ kLimitStream);
  Limits limited = limits(sketch, limit);
  if (unsolvable_) {
    // Draws the level again with the same random numbers and one impossible crossing.
    Random plant(seed, index ^ kPlantStream);
    const int which = int(plant.below(uint32_t(sketch.crossings())));
    sketch = draw(style, difficulty, random, {which, sketch.fastest()});
    query = "beyond-" + sketch.plantedWhat();
    name += "-without-" + sketch.plantedWhat();
  }
  return {std::move(name), std::move(query), difficulty, std::move(sketch), std::move(limited)};
}

}  // namespace obby::gen

// The game that worlds learn from: what a move is worth, when a playthrough is over, where the next
// one begins. What becomes of a world follows from its level, its moves and numbers drawn for its
// number and decision, so that it does not show where or in which order worlds are played.
#pragma once

#include "base/random.h"
#include "policy/moves.h"
#include "train/guide_view.h"

namespace obby::train {

constexpr uint32_t kMostReached = 16;    // states to begin from that a level keeps
constexpr float kNear = 24;              // studs of the way at a time that a playthrough can get on
constexpr uint32_t kRememberEvery = 64;  // about one state in so many decisions

// What is worth how much.
struct RewardSettings {
  float stud = 0.1f;  // of the way left, less than ever before in this playthrough
  float goal = 5;
  float death = -1;         // and anything else that ends a playthrough
  float decision = -0.01f;  // time passes
  float jump = -0.05f;      // each that is made
};

// Shares of playthroughs that begin where another had come to.
struct RestartShares {
  float unsolved = 0.3f;  // of levels that nobody has solved from the start yet
  float solved = 0.3f;    // of the others
};

// One world that learns.
struct Player {
  sim::World world;
  Turns ahead = 0;     // of what it saw last; not kept, for it looks again before it moves
  float least = 0;     // studs of the way left, the least in this playthrough
  uint32_t ticks = 0;  // of this playthrough
  bool fromStart = true;
  uint32_t jumps = 0;  // of the world, that have been judged
};

// A state to begin from, as somebody had come to it.
struct Reached {
  sim::World world;
  float least;  // as theirs: from the place alone nobody knows how far along the way it is
};

// A level to learn on, as its worlds read it. Plain spans, for device code.
struct TrainingView {
  level::LevelView level;
  level::QueryView query;
  policy::SurroundingsView surroundings;
  GuideView guide;
  sim::World start;
  const sim::LooseBody* startLoose = nullptr;  // (level.looseCount)
  uint32_t mostTicks = 0;  // after which a playthrough is given up, at the end of an iteration

  OBBY_DEVICE policy::Scene scene() const { return {level, query, surroundings}; }
};

template <class Table>
OBBY_DEVICE void forTables(TrainingView& v, Table&& table) {
  forTables(v.level, table);
  forTables(v.query, table);
  forTables(v.surroundings, table);
  forTables(v.guide, table);
  table(v.startLoose, v.level.looseCount);
}

// What has happened on a level.
struct PlaceCounts {
  uint32_t played = 0;      // playthroughs of the level
  uint32_t reached = 0;     // states to begin from
  uint32_t solvedOnce = 0;  // 1: somebody has solved it from the start
  // Of playthroughs that began at the start, since the last look.
  uint32_t fromStart = 0, solved = 0;
};

// A level with its worlds.
struct PlaceView {
  const TrainingView* on;
  Player* players;        // (worlds)
  sim::LooseBody* loose;  // (worlds, looseStride)
  Reached* reached;       // (kMostReached), of which counts->reached are there
  PlaceCounts* counts;
  uint32_t worlds, looseStride;

  OBBY_DEVICE sim::LooseBody* looseOf(uint32_t player) const {
    return loose + size_t(player) * looseStride;
  }
};

// What numbers are drawn for.
enum class Draw : uint64_t { move = 0x6d6f7665, begin = 0x626567696e };

// `decision`: of the world, counted from the beginning of learning; `world`: its number among all.
OBBY_DEVICE Random drawsOf(uint64_t seed, Draw use, uint64_t decision, uint32_t world) {
  return {seed ^ uint64_t(use), decision << 32 | world};
}

// What came of a move.
struct Step {
  float reward = 0;
  bool ended = false;  // by a goal, a death, a broken rule
};

OBBY_DEVICE bool hasEnded(const Player& p) { return p.world.outcome != sim::Outcome::running; }

// After the ticks of a move.
OBBY_DEVICE Step judge(const TrainingView& on, const RewardSettings& worth, Player& p) {
  Step step;
  step.reward = worth.decision;
  const float left = on.guide.left(p.world.position, p.least - kNear, p.world.waypoints);
  if (left < p.least) {
    step.reward += worth.stud * (p.least - left);
    p.least = left;
  }
  step.reward += worth.jump * float(p.world.jumps - p.jumps);
  p.jumps = p.world.jumps;
  p.ticks += policy::kDecisionTicks;
  step.ended = hasEnded(p);
  if (step.ended) step.reward += p.world.outcome == sim::Outcome::goal ? worth.goal : worth.death;
  return step;
}

// Puts a player where its next playthrough begins: at the start, or where another had come to.
OBBY_DEVICE void restart(const PlaceView& place, uint32_t player, const RestartShares& shares,
                         Random& random) {
  Player& p = place.players[player];
  const uint32_t reached = place.counts->reached;
  const float share = place.counts->solvedOnce != 0 ? shares.solved : shares.unsolved;
  const GuideView& guide = place.on->guide;
  p.fromStart = reached == 0 || random.unit() >= share;
  if (p.fromStart) {
    p.world = place.on->start;
    p.least = guide.left(p.world.position, guide.studs() - kNear, 0);
  } else {
    const Reached& from = place.reached[random.below(reached)];
    p.world = from.world;
    p.least = from.least;
  }
  p.ticks = 0;
  p.jumps = p.world.jumps;
  sim::LooseBody* const loose = place.looseOf(player);
  for (uint32_t b = 0; b < place.on->level.looseCount; ++b) loose[b] = place.on->startLoose[b];
}

// Keeps a state in which the player stands, now and then; bodies are not kept, so levels with such
// begin at the start.
OBBY_DEVICE void remember(const PlaceView& place, const Player& p, Random& random) {
  if (p.world.floorlessSteps != 0 || place.on->level.looseCount != 0) return;
  if (random.below(kRememberEvery) != 0) return;
  uint32_t& reached = place.counts->reached;
  place.reached[reached < kMostReached ? reached++ : random.below(kMostReached)] = {p.world,
                                                                                    p.least};
}

// What numbers settle() draws with.
struct SettleRules {
  uint64_t seed;
  RestartShares restarts;
  uint64_t decision;    // that was made last
  bool endOfIteration;  // those that take too long are cut: their last value stands for the rest
};

// After a decision of all worlds of a place, `first` its first world's number: begins anew what is
// over. One after the other, for they share what was reached.
OBBY_DEVICE void settle(const PlaceView& place, const SettleRules& rules, uint32_t first) {
  for (uint32_t i = 0; i < place.worlds; ++i) {
    const Player& p = place.players[i];
    Random random = drawsOf(rules.seed, Draw::begin, rules.decision, first + i);
    if (!hasEnded(p) && !(rules.endOfIteration && p.ticks >= place.on->mostTicks)) {
      remember(place, p, random);
      continue;
    }
    const bool solved = p.fromStart && p.world.outcome == sim::Outcome::goal;
    ++place.counts->played;
    place.counts->fromStart += p.fromStart;
    place.counts->solved += solved;
    place.counts->solvedOnce |= uint32_t(solved);
    restart(place, i, rules.restarts, random);
  }
}

// All worlds at the start of a level that is new to the place.
OBBY_DEVICE void beginLevel(const PlaceView& place) {
  *place.counts = {};
  Random none(0, 0);  // nothing was reached yet, so nothing is drawn
  for (uint32_t i = 0; i < place.worlds; ++i) restart(place, i, {}, none);
}

}  // namespace obby::train

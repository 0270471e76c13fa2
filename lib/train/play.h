// The training environment: rewards, ends of episodes and restarts. A world is a function of its
// level, its moves and random numbers drawn for its index and decision. So the engine and the order
// of play do not matter.
#pragma once

#include "base/random.h"
#include "policy/moves.h"
#include "train/guide_view.h"

namespace obby::train {

constexpr uint32_t kMaxReached = 16;     // restart states kept for each level
constexpr float kNear = 24;              // max studs of route progress at once
constexpr uint32_t kRememberEvery = 64;  // mean number of decisions per kept state

// Rewards of events.
struct RewardSettings {
  float stud = 0.1f;  // per stud closer to the goal than before in the episode
  float goal = 5;
  float death = -1;         // reward of a death or any other failure
  float decision = -0.01f;  // cost of time
  float jump = -0.05f;      // per jump
};

// Shares of episodes that begin at a restart state.
struct RestartShares {
  float unsolved = 0.3f;  // levels not yet solved from the start
  float solved = 0.3f;    // other levels
};

// A player of one world, with the state of its episode.
struct Player {
  sim::World world;
  Turns ahead = 0;     // heading of its last observation; not saved, since observing sets it
  float minLeft = 0;   // min studs left on the route in this episode
  uint32_t ticks = 0;  // ticks of this episode
  bool fromStart = true;
  uint32_t jumps = 0;  // jumps of the world that were already penalised
};

// A restart state, with the progress made on the way.
struct Reached {
  sim::World world;
  float minLeft;  // see Player::minLeft; the position alone does not determine it
};

// A training level for device code, as plain spans.
struct TrainingView {
  level::LevelView level;
  level::QueryView query;
  policy::SurroundingsView surroundings;
  GuideView guide;
  sim::World start;
  const sim::RigidBody* startBodies = nullptr;  // (level.bodyCount)
  uint32_t maxTicks = 0;  // an episode is cut after this many ticks, at the end of an iteration

  OBBY_DEVICE policy::Scene scene() const { return {level, query, surroundings}; }
};

template <class Table>
OBBY_DEVICE void forTables(TrainingView& v, Table&& table) {
  forTables(v.level, table);
  forTables(v.query, table);
  forTables(v.surroundings, table);
  forTables(v.guide, table);
  table(v.startBodies, v.level.bodyCount);
}

// Statistics of a level at a place.
struct PlaceCounts {
  uint32_t played = 0;      // episodes on the level
  uint32_t reached = 0;     // restart states
  uint32_t solvedOnce = 0;  // 1: an episode from the start has solved it
  // Episodes from the start, since the last tally.
  uint32_t fromStart = 0, solved = 0;
};

// A level with its worlds.
struct PlaceView {
  const TrainingView* on;
  Player* players;         // (worlds)
  sim::RigidBody* bodies;  // (worlds, bodyStride)
  Reached* reached;        // (kMaxReached), the first counts->reached are valid
  PlaceCounts* counts;
  uint32_t worlds, bodyStride;

  OBBY_DEVICE sim::RigidBody* bodiesOf(uint32_t player) const {
    return bodies + size_t(player) * bodyStride;
  }
};

// Purposes of random numbers.
enum class Draw : uint64_t { move = 0x6d6f7665, begin = 0x626567696e };

// Returns the random numbers for one decision. `decision`: number of the world's decisions since
// the start of training; `world`: its index among all worlds.
OBBY_DEVICE Random drawsOf(uint64_t seed, Draw use, uint64_t decision, uint32_t world) {
  return {seed ^ uint64_t(use), decision << 32 | world};
}

// The result of a move.
struct Step {
  float reward = 0;
  bool ended = false;  // a goal, a death or a broken rule ended the episode
};

OBBY_DEVICE bool hasEnded(const Player& p) { return p.world.outcome != sim::Outcome::running; }

// Returns the result after the ticks of a move.
OBBY_DEVICE Step judge(const TrainingView& on, const RewardSettings& worth, Player& p) {
  Step step;
  step.reward = worth.decision;
  const float left = on.guide.left(p.world.position, p.minLeft - kNear, p.world.waypoints);
  if (left < p.minLeft) {
    step.reward += worth.stud * (p.minLeft - left);
    p.minLeft = left;
  }
  step.reward += worth.jump * float(p.world.jumps - p.jumps);
  p.jumps = p.world.jumps;
  p.ticks += policy::kDecisionTicks;
  step.ended = hasEnded(p);
  if (step.ended) step.reward += p.world.outcome == sim::Outcome::goal ? worth.goal : worth.death;
  return step;
}

// Starts the player's next episode: at the start of the level, or at a restart state.
OBBY_DEVICE void restart(const PlaceView& place, uint32_t player, const RestartShares& shares,
                         Random& random) {
  Player& p = place.players[player];
  const uint32_t reached = place.counts->reached;
  const float share = place.counts->solvedOnce != 0 ? shares.solved : shares.unsolved;
  const GuideView& guide = place.on->guide;
  p.fromStart = reached == 0 || random.unit() >= share;
  if (p.fromStart) {
    p.world = place.on->start;
    p.minLeft = guide.left(p.world.position, guide.studs() - kNear, 0);
  } else {
    const Reached& from = place.reached[random.below(reached)];
    p.world = from.world;
    p.minLeft = from.minLeft;
  }
  p.ticks = 0;
  p.jumps = p.world.jumps;
  sim::RigidBody* const bodies = place.bodiesOf(player);
  for (uint32_t b = 0; b < place.on->level.bodyCount; ++b) bodies[b] = place.on->startBodies[b];
}

// Keeps some of the states in which the player stands. Bodies are not kept, so levels with dynamic
// bodies always begin at the start.
OBBY_DEVICE void remember(const PlaceView& place, const Player& p, Random& random) {
  if (p.world.floorlessSteps != 0 || place.on->level.bodyCount != 0) return;
  if (random.below(kRememberEvery) != 0) return;
  uint32_t& reached = place.counts->reached;
  place.reached[reached < kMaxReached ? reached++ : random.below(kMaxReached)] = {p.world,
                                                                                  p.minLeft};
}

// Parameters of settle().
struct SettleRules {
  uint64_t seed;
  RestartShares restarts;
  uint64_t decision;    // the last one played
  bool endOfIteration;  // long episodes are cut: their last value estimates the rest
};

// Restarts ended episodes after a decision of all worlds of a place. `first`: index of its first
// world. Worlds are handled in order, as they share the restart states.
OBBY_DEVICE void settle(const PlaceView& place, const SettleRules& rules, uint32_t first) {
  for (uint32_t i = 0; i < place.worlds; ++i) {
    const Player& p = place.players[i];
    Random random = drawsOf(rules.seed, Draw::begin, rules.decision, first + i);
    if (!hasEnded(p) && !(rules.endOfIteration && p.ticks >= place.on->maxTicks)) {
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

// Puts all worlds at the start of a new level.
OBBY_DEVICE void beginLevel(const PlaceView& place) {
  *place.counts = {};
  Random none(0, 0);  // no restart states exist yet, so none is drawn
  for (uint32_t i = 0; i < place.worlds; ++i) restart(place, i, {}, none);
}

}  // namespace obby::train

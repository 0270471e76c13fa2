// Kernels that play an iteration. In a tick, every world observes, with one thread per part of the
// observation. Then the network runs (product.h), every world moves, and every place restarts ended
// episodes.
#pragma once

#include "policy/decision.h"
#include "policy/network.h"
#include "sim/rules.h"
#include "sim/tick.h"
#include "train/play.h"

namespace obby::train {

// A place on a device. Its level's tables and its worlds' bodies are in device memory.
struct DevicePlace {
  TrainingView on;
  sim::RigidBody* bodies;  // (worldsOfPlace, on.level.bodyCount)
  bool isNew;              // the place's worlds have not begun yet
};

struct PlayArguments {
  const DevicePlace* places;
  Player* players;      // (places, worldsOfPlace)
  Reached* reached;     // (places, kMaxReached)
  PlaceCounts* counts;  // (places)
  uint32_t worldsOfPlace, worlds;
  uint32_t firstWorld;  // index among the worlds of all ranks
  RewardSettings reward;
  SettleRules rules;  // rules of the current decision
  const float *means, *scales;
  float valueMean, valueDeviation;
  // Rows of the current tick, (worlds).
  float* inputs;         // (worlds, kInputs)
  const float* outputs;  // (worlds, kPaddedOutputs)
  policy::Decision* decisions;
  float *values, *rewards;
  uint8_t* done;
  // Sums of inputs so far, (env groups, kInputs).
  double *sums, *squares;
  uint32_t worldsOfEnvGroup;
};

OBBY_DEVICE PlaceView placeView(const PlayArguments& a, uint32_t place) {
  const DevicePlace& p = a.places[place];
  return {&p.on,
          a.players + size_t(place) * a.worldsOfPlace,
          p.bodies,
          a.reached + size_t(place) * kMaxReached,
          a.counts + place,
          a.worldsOfPlace,
          p.on.level.bodyCount};
}

OBBY_DEVICE void observeWorld(const PlayArguments& a, uint32_t i) {
  const uint32_t w = i / policy::kViewThreads, part = i % policy::kViewThreads;
  if (part >= uint32_t(policy::kViewParts)) return;
  const PlaceView place = placeView(a, w / a.worldsOfPlace);
  Player& player = place.players[w % a.worldsOfPlace];
  const policy::Scene scene = place.on->scene();
  const sim::NextRegion next = sim::nextRegion(scene.query, player.world);
  const Turns ahead = policy::aheadOf(*next.region, player.world);
  policy::observePart(scene, player.world, place.bodiesOf(w % a.worldsOfPlace), next, ahead,
                      int(part), a.inputs + size_t(w) * policy::kInputs);
  if (part == 0) player.ahead = ahead;
}

// Adds the raw inputs of an env group's worlds, in the same order as on the CPU.
OBBY_DEVICE void countInputs(const PlayArguments& a, uint32_t i) {
  const uint32_t first = i / policy::kInputs * a.worldsOfEnvGroup, column = i % policy::kInputs;
  double sum = a.sums[i], squares = a.squares[i];
  for (uint32_t w = first; w < first + a.worldsOfEnvGroup; ++w) {
    const double v = double(a.inputs[size_t(w) * policy::kInputs + column]);
    sum += v;
    squares += v * v;
  }
  a.sums[i] = sum;
  a.squares[i] = squares;
}

// `i` runs over (worlds, kInputs).
OBBY_DEVICE void normaliseInput(const PlayArguments& a, uint32_t i) {
  const uint32_t column = i % policy::kInputs;
  a.inputs[i] = policy::normalised(a.inputs[i], a.means[column], a.scales[column]);
}

OBBY_DEVICE void expectValue(const PlayArguments& a, uint32_t w) {
  const float* const out = a.outputs + size_t(w) * policy::kPaddedOutputs;
  a.values[w] = a.valueMean + a.valueDeviation * out[policy::kMoves];
}

OBBY_DEVICE nn::Drawn decideMove(const PlayArguments& a, const policy::Scene& scene,
                                 const sim::World& world, uint32_t w) {
  const bool mayJump = policy::jumpAllowed(scene, world);
  const float draw = drawsOf(a.rules.seed, Draw::move, a.rules.decision, a.firstWorld + w).unit();
  const nn::Drawn drawn =
      policy::drawMove(a.outputs + size_t(w) * policy::kPaddedOutputs, mayJump, draw);
  a.decisions[w] = {{drawn.action, drawn.logProbability, 0, 0}, mayJump};
  expectValue(a, w);
  return drawn;
}

// Samples a move and plays it. `kDynamic`: only worlds with dynamic bodies, otherwise only those
// without; see sim::tick.
template <bool kDynamic>
OBBY_DEVICE void actOne(const PlayArguments& a, uint32_t w) {
  const PlaceView place = placeView(a, w / a.worldsOfPlace);
  const TrainingView& on = *place.on;
  if ((on.level.bodyCount != 0) != kDynamic) return;
  Player player = place.players[w % a.worldsOfPlace];
  sim::RigidBody* const bodies = kDynamic ? place.bodiesOf(w % a.worldsOfPlace) : nullptr;
  const nn::Drawn drawn = decideMove(a, on.scene(), player.world, w);
  const sim::Action action = policy::actionOf(drawn.action, player.ahead);
  for (uint32_t t = 0; t < policy::kDecisionTicks; ++t) {
    const sim::Before before = sim::beforeOf(player.world);
    sim::tick<kDynamic>(player.world, bodies, on.level, action);
    sim::applyRules(player.world, before, bodies, on.level, on.query);
  }
  const Step step = judge(on, a.reward, player);
  a.rewards[w] = step.reward;
  a.done[w] = step.ended;
  place.players[w % a.worldsOfPlace] = player;
}

OBBY_DEVICE void settlePlace(const PlayArguments& a, uint32_t place) {
  settle(placeView(a, place), a.rules, a.firstWorld + place * a.worldsOfPlace);
}

OBBY_DEVICE void beginPlace(const PlayArguments& a, uint32_t place) {
  if (a.places[place].isNew) beginLevel(placeView(a, place));
}

}  // namespace obby::train

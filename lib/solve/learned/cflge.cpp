#include "solve/learned/cflge.h"

#include <algorithm>

#include "policy/policy.h"
#include "solve/learned/soft_window.h"

namespace obby::solve::learned {

namespace {

constexpr uint64_t kPlayers = 1ull << 32;  // streams of random numbers
constexpr Turns kNorth = 0;                // all observations look that way: moves mean the same

}  // namespace

Cflge::Cflge(const Problem& problem, uint64_t seed, const CflgeSettings& settings,
             const Machine& machine)
    : LearnedSearch(problem, seed, machine),
      settings_(settings),
      module_(seed),
      policy_(settings.policy, seed),
      memory_(settings.room),
      groups_(settings.groups) {
  for (uint32_t i = 0; i < settings.groups * kGroup; ++i) {
    Group& g = groups_[i / kGroup];
    g.players.emplace_back(seed, kPlayers + i);
    restart(g, g.players.back());
  }
  for (Group& g : groups_) {
    g.inputs.resize(kGroup * kPolicyInputs);
    g.places.resize(kGroup * kPlace);
  }
}

void Cflge::playAndLearn() {
  pool().run(int(groups_.size()), [&](int g) { play(groups_[size_t(g)]); });
  for (Group& g : groups_) {
    for (Episode& e : g.ended) take(e);
    for (Track& t : g.tracks) {
      goals_.add(t.path);
      memory_.add(std::make_shared<const Track>(std::move(t)));
    }
    count(g.steps);
    returns_.add(g.returns);
    g.ended.clear();
    g.tracks.clear();
    g.steps = 0;
    g.returns = {};
  }
  decided_ += settings_.decisions * settings_.groups * kGroup;
  if (decided_ >= settings_.begin && memory_.size() > 0) learn();
}

// As many steps for a decision as were settled, a few each round; goals are ranked anew rarely.
void Cflge::learn() {
  const double decisions = settings_.decisions * settings_.groups * kGroup;
  if (settings_.learns) {
    moduleDebt_ += decisions * double(settings_.moduleSteps);
    policyDebt_ += decisions * double(settings_.policySteps);
  }
  float sum = 0;
  uint32_t steps = 0;
  for (; moduleDebt_ >= 1; --moduleDebt_, ++steps) sum += module_.learn(pool(), memory_);
  if (steps > 0) moduleLosses_.push_back(sum / float(steps));
  for (; policyDebt_ >= 1; --policyDebt_) policy_.learn(pool(), memory_, module_);
  if (ranked_ != 0 && decided_ < ranked_ + settings_.refresh) return;
  goals_.refresh(pool(), module_);
  ranked_ = decided_;
}

void Cflge::play(Group& g) {
  for (uint32_t t = 0; t < settings_.decisions; ++t) {
    for (size_t i = 0; i < kGroup; ++i) see(g.players[i], g.inputs.data() + i * kPolicyInputs);
    const float* outputs = g.pass.forward(policy_.net(), g.inputs.data(), kGroup);
    for (size_t i = 0; i < kGroup; ++i) {
      decide(g.players[i], outputs + i * size_t(policy::kMoves) * kQuantiles);
    }
    for (uint32_t k = 0; k < policy::kDecisionTicks; ++k) tick(g);
    reach(g);
    for (Player& p : g.players) endDecision(g, p);
  }
}

// Notes where the player is; fills `inputs`, (kPolicyInputs), with what is seen there.
void Cflge::see(Player& p, float* inputs) const {
  const sim::World& world = p.episode.world;
  const sim::LooseBody* const loose = p.episode.loose.data();
  policy::observe(scene(), world, loose, nextRegion(scene().query, world), kNorth, inputs);
  float place[kPlace];
  placeOf(problem(), world, loose, place);
  p.path->places.insert(p.path->places.end(), place, place + kPlace);
  p.path->stands.push_back(grounded(world));
  p.track.inputs.insert(p.track.inputs.end(), inputs, inputs + policy::kInputs);
  p.track.mayJump.push_back(policy::jumpAllowed(scene(), world));
  const float nowhere[kPlace] = {};
  const float* const goal =
      p.count == 0 ? nowhere : p.subgoals.data() + std::min(p.next, p.count - 1) * kPlace;
  observeGoal(place, goal, inputs + policy::kInputs);
  p.track.goals.insert(p.track.goals.end(), goal, goal + kPlace);
}

void Cflge::decide(Player& p, const float* outputs) {
  const bool mayJump = p.track.mayJump.back() != 0;
  if (p.explores()) {
    p.action = allowed(p.keys.next(p.random), p.episode.world);
  } else {
    int move = bestMove(outputs, mayJump);
    if (p.random.unit() < settings_.chance) move = int(p.random.below(policy::kMoves));
    p.action = allowed(policy::actionOf(move, kNorth), p.episode.world);
  }
  const int direction = p.action.walk ? p.action.heading >> 12 : policy::kHeadings;
  p.track.moves.push_back(uint8_t(direction * 2 + (p.action.jump ? 1 : 0)));
}

void Cflge::tick(Group& g) {
  std::vector<Episode*> episodes;
  std::vector<sim::Action> held;
  for (Player& p : g.players) {
    if (!goesOn(p.episode)) continue;
    episodes.push_back(&p.episode);
    held.push_back(allowed(p.action, p.episode.world));
  }
  advance(episodes, held.data());
  g.steps += episodes.size();
}

// Who has come within reach of a sub-goal goes on to the next.
void Cflge::reach(Group& g) {
  for (size_t i = 0; i < kGroup; ++i) {
    const Episode& e = g.players[i].episode;
    placeOf(problem(), e.world, e.loose.data(), g.places.data() + i * kPlace);
  }
  module_.encode(g.places.data(), kGroup, g.encoder, g.points);
  const float* const points = g.points.data();
  for (size_t i = 0; i < kGroup; ++i) {
    Player& p = g.players[i];
    const auto reached = [&](size_t s) {
      return latentDistance2(points + i * kLatent, p.points.data() + s * kLatent) <
             module_.reach() * module_.reach();
    };
    if (p.explores()) {
      ++p.explored;
    } else if (passSubgoals(p.next, p.count, reached)) {
      p.waited = 0;
      if (p.explores()) ++g.returns.reached;
    } else {
      ++p.waited;
    }
  }
}

bool Cflge::isOver(const Player& p) const {
  return !goesOn(p.episode) || p.explored >= settings_.explore || p.waited >= settings_.patience;
}

void Cflge::endDecision(Group& g, Player& p) {
  if (!isOver(p)) return;
  float inputs[kPolicyInputs];
  see(p, inputs);
  p.track.ended = !goesOn(p.episode);
  p.track.path = std::move(p.path);
  g.tracks.push_back(std::move(p.track));
  g.ended.push_back(std::move(p.episode));
  restart(g, p);
}

// Sets out for a goal along the way that led there, thinned.
void Cflge::restart(Group& g, Player& p) {
  p.episode = begin();
  p.path = std::make_shared<Path>();
  p.track = {};
  p.next = p.count = 0;
  p.waited = p.explored = 0;
  p.keys.letGo();
  if (goals_.empty()) return;
  const Goal& goal = goals_.draw(p.random);
  const float* const places = goal.path->place(0);
  module_.encode(places, goal.index + 1, g.encoder, g.points);
  const float* const points = g.points.data();
  const std::vector<uint32_t> kept = thinned(points, goal.index + 1, module_.reach());
  p.count = kept.size();
  p.subgoals.clear();
  p.points.clear();
  for (const uint32_t i : kept) {
    p.subgoals.insert(p.subgoals.end(), places + i * kPlace, places + (i + 1) * kPlace);
    p.points.insert(p.points.end(), points + i * kLatent, points + (i + 1) * kLatent);
  }
  ++g.returns.tried;
}

}  // namespace obby::solve::learned

#include "baselines/pbge.h"

#include <algorithm>
#include <tuple>

#include "baselines/soft_window.h"
#include "policy/policy.h"

namespace obby::baselines {

namespace {

constexpr float kNewNearby = 0.1f;  // share of aims in a new cell nearby, if any
constexpr float kNearby = 0.25f;    // share of the remaining aims
constexpr int kAims = 8;            // places tried to find a new cell
constexpr uint32_t kFarthest = 8;   // max distance of an aim, in cells

geom::Region around(Vec3 place, float width) {
  return {{place, {}}, {0.5f * width, width, 0.5f * width}};
}

}  // namespace

Pbge::Pbge(const Problem& problem, uint64_t seed, const PbgeSettings& settings,
           const Machine& machine)
    : LearnedSearch(problem, seed, machine, settings.groups * kGroup, settings.forgetFrom),
      settings_(settings),
      policy_(settings.policy, seed, device()),
      made_(settings.decisions, settings.groups * kGroup),
      groups_(settings.groups) {
  choice_.update(cellCount());
  for (Group& g : groups_) g.pass = NetPass(device());
  for (uint32_t i = 0; i < made_.players; ++i) {
    Group& g = groups_[i / kGroup];
    g.players.emplace_back(seed, kPlayerStreams + i, (i + 1) % kGroup == 0);
    restart(g, g.players.back());
  }
}

void Pbge::playAndLearn() {
  forGroups(groups_.size(), [&](size_t first, size_t count) {
    play(std::span(groups_).subspan(first, count), uint32_t(first) * kGroup);
  });
  for (Group& g : groups_) {
    for (Episode& e : g.ended) take(e);
    for (const uint32_t cell : g.acted) choice_.act(cell);
    count(g.steps);
    returns_.add(g.returns);
    g.ended.clear();
    g.acted.clear();
    g.returns = {};
    g.steps = 0;
  }
  choice_.update(cellCount());
  if (settings_.learns) policy_.learn(pool(), made_);
}

void Pbge::markFollowed(std::vector<uint8_t>& used) const {
  for (const Group& g : groups_) {
    for (const Player& p : g.players) {
      if (p.subgoals > 0) used[p.kept] = 1;
    }
  }
}

// `first`: index of the groups' first player.
void Pbge::play(std::span<Group> groups, uint32_t first) {
  const size_t count = groups.size() * kGroup;
  const auto player = [&](size_t i) -> Player& { return groups[i / kGroup].players[i % kGroup]; };
  std::vector<View> views(count);
  std::vector<float> beyond(count * size_t(policy::kInputs));
  for (uint32_t t = 0; t <= settings_.decisions; ++t) {
    const size_t row = size_t(t) * made_.players + first;
    const bool last = t == settings_.decisions;
    float* const inputs = last ? beyond.data() : made_.inputs.data() + row * policy::kInputs;
    for (size_t i = 0; i < count; ++i) views[i] = lookFrom(player(i));
    see(views, inputs);
    const float* outputs = groups[0].pass.forward(policy_.net(), inputs, count);
    for (size_t i = 0; i < count; ++i, outputs += policy::kPaddedOutputs) {
      if (last) {
        made_.last[first + i] = outputs[policy::kMoves];
      } else {
        decide(groups[i / kGroup], player(i), outputs, row + i);
      }
    }
    if (last) return;
    for (uint32_t k = 0; k < policy::kDecisionTicks; ++k) tick(groups);
    for (size_t i = 0; i < count; ++i) endDecision(groups[i / kGroup], player(i), row + i);
  }
}

// Returns a view in which the next place to reach replaces the query's next region.
View Pbge::lookFrom(Player& p) const {
  const bool explores = p.mode == Mode::exploring;
  const Vec3 place = explores          ? p.aim
                     : p.subgoals == 0 ? p.episode.world.position
                                       : passed(p.kept)[p.next].place;
  const geom::Region region = around(place, cellWidth());
  p.ahead = policy::aheadOf(region, p.episode.world);
  return {&p.episode, region, p.ahead};
}

void Pbge::decide(Group& g, Player& p, const float* outputs, size_t row) {
  if (p.episode.cell != kNone && p.mode != Mode::repeating) g.acted.push_back(p.episode.cell);
  p.reward = 0;
  p.done = false;
  made_.values[row] = outputs[policy::kMoves];
  if (p.mode == Mode::repeating) {
    decideAsKept(p, row);
  } else if (p.mode == Mode::exploring && !p.byPolicy) {
    made_.makers[row] = Maker::explorer;
    p.action = allowed(p.keys.next(p.random), p.episode.world);
  } else {
    decideByPolicy(p, outputs, row);
  }
}

// Returns the number of decisions that the followed trajectory took to the next sub-goal.
uint32_t Pbge::decisionsDue(const Player& p) const {
  const std::vector<Passed>& cells = passed(p.kept);
  const uint32_t before = p.next == 0 ? 0 : cells[p.next - 1].tick;
  return (cells[p.next].tick - before) / policy::kDecisionTicks;
}

// Samples an action. The temperature grows once the player is overdue at a sub-goal, or finds no
// new cell.
void Pbge::decideByPolicy(Player& p, const float* outputs, size_t row) {
  const bool explores = p.mode == Mode::exploring;
  const uint32_t calm = explores ? settings_.calm : decisionsDue(p);
  const uint32_t over = p.waited > calm ? p.waited - calm : 0;
  const float unrest = settings_.unrest * float(over);
  const float sharpness = 1 / (1 + unrest * unrest);
  float logits[policy::kMoves], chances[policy::kMoves];
  for (int m = 0; m < policy::kMoves; ++m) logits[m] = outputs[m] * sharpness;
  const bool mayJump = policy::jumpAllowed(scene(), p.episode.world);
  policy::probabilitiesOf(logits, mayJump, chances);
  const int move = policy::draw<float>(logits, mayJump, p.random);
  p.action = policy::actionOf(move, p.ahead);
  made_.makers[row] = explores ? Maker::explorer : Maker::policy;
  made_.sharpness[row] = sharpness;
  made_.made[row] = {{move, logOf(chances[move]), 0, 0}, mayJump};
}

// The policy imitates the kept decision; the actions themselves are replayed tick by tick.
void Pbge::decideAsKept(Player& p, size_t row) {
  const bool mayJump = policy::jumpAllowed(scene(), p.episode.world);
  RunCursor ahead = p.cursor;
  const sim::Action action = ahead.next(actions(p.kept));
  made_.makers[row] = Maker::kept;
  made_.made[row] = {{nearestMove(action, p.ahead, mayJump), 0, 0, 0}, mayJump};
}

void Pbge::tick(std::span<Group> groups) {
  std::vector<std::pair<Group*, Player*>> players;
  std::vector<Episode*> episodes;
  std::vector<sim::Action> held;
  for (Group& g : groups) {
    for (Player& p : g.players) {
      if (isOver(p)) continue;
      players.emplace_back(&g, &p);
      episodes.push_back(&p.episode);
      if (p.mode == Mode::repeating) p.action = p.cursor.next(actions(p.kept));
      p.action = allowed(p.action, p.episode.world);
      held.push_back(p.action);
      ++g.steps;
    }
  }
  advance(episodes, held.data());
  for (const auto& [g, p] : players) reach(*g, *p);
}

// Handles a player that reaches a sub-goal or, while exploring by the policy, its aim.
void Pbge::reach(Group& g, Player& p) const {
  if (p.mode == Mode::exploring) {
    const geom::Region there = around(p.aim, cellWidth());
    if (p.byPolicy && geom::distance(there, p.episode.world.position) <= 0) aim(p);
    return;
  }
  const std::vector<Passed>& cells = passed(p.kept);
  const auto reached = [&](size_t i) { return cells[i].key == p.episode.key; };
  if (!passSubgoals(p.next, p.subgoals, reached)) return;
  const bool last = p.next == p.subgoals;
  p.reward += last ? settings_.last : settings_.subgoal;
  p.waited = 0;
  if (p.mode != Mode::returning || !last) return;
  ++g.returns.reached;
  explore(p);
}

bool Pbge::isOver(const Player& p) const {
  if (!goesOn(p.episode)) return true;
  if (p.mode == Mode::repeating) return p.next == p.subgoals;
  return p.waited >= settings_.patience + (p.mode == Mode::returning ? decisionsDue(p) : 0);
}

void Pbge::endDecision(Group& g, Player& p, size_t row) {
  ++p.waited;
  if (p.mode == Mode::exploring) {
    if (p.episode.newCells != p.newCells) p.waited = 0;
    p.newCells = p.episode.newCells;
    if (++p.explored % settings_.aimFor == 0) aim(p);
  }
  const bool over = isOver(p);
  made_.rewards[row] = p.reward;
  made_.done[row] = p.done || over;
  if (!over) return;
  if (!p.episode.repeats) g.ended.push_back(std::move(p.episode));
  restart(g, p);
}

void Pbge::restart(Group& g, Player& p) const {
  p.episode = begin();
  p.next = 0;
  p.waited = 0;
  p.cursor = {};
  std::tie(p.kept, p.subgoals) = keptTo(choice_.pick(p.random));
  p.episode.repeats = p.repeats && p.subgoals > 0;
  if (p.episode.repeats) {
    p.mode = Mode::repeating;
  } else if (p.subgoals == 0) {
    explore(p);
  } else {
    p.mode = Mode::returning;
    ++g.returns.tried;
  }
}

// Starts to explore. Half of the players explore by the policy, the others at random.
void Pbge::explore(Player& p) const {
  p.mode = Mode::exploring;
  p.byPolicy = p.random.below(2) == 0;
  p.explored = p.waited = 0;
  p.newCells = p.episode.newCells;
  p.keys.letGo();
  p.done = true;
  aim(p);
}

// Selects an aim: rarely a place nearby in a new cell, sometimes any place nearby, otherwise a cell
// of the archive.
void Pbge::aim(Player& p) const {
  if (p.random.unit() < kNewNearby) {
    for (int i = 0; i < kAims; ++i) {
      p.aim = placeNear(p);
      if (archive().find(keyAt(p.episode, p.aim)) == kNone) return;
    }
  }
  p.aim =
      p.random.unit() < kNearby ? placeNear(p) : archive().world(choice_.pick(p.random)).position;
}

Vec3 Pbge::placeNear(Player& p) const {
  const SinCos direction = sinCos(Turns(p.random.below(policy::kHeadings) << 12));
  const float cells = 1 + float(p.random.below(kFarthest));
  return p.episode.world.position + directionOf(direction) * (cells * cellWidth());
}

}  // namespace obby::baselines

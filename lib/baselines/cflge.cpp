#include "baselines/cflge.h"

#include <algorithm>

#include "baselines/soft_window.h"
#include "policy/policy.h"
#include "solve/search/rollouts/known_way.h"

namespace obby::baselines {

namespace {

constexpr uint64_t kFollowers = 2ull << 32;  // streams of random numbers
constexpr Turns kNorth = 0;                  // all observations look north

}  // namespace

Cflge::Cflge(const Problem& problem, uint64_t seed, const CflgeSettings& settings,
             const Machine& machine)
    : LearnedSearch(problem, seed, machine, settings.groups * kGroup, settings.forgetFrom),
      settings_(settings),
      module_(seed, device()),
      policy_(settings.policy, seed, device()),
      ranking_(device()),
      memory_(settings.room),
      groups_(settings.groups) {
  for (Group& g : groups_) {
    g.pass = NetPass(device());
    g.encoder = NetPass(device());
  }
  for (uint32_t i = 0; i < settings.groups * kGroup; ++i) {
    Group& g = groups_[i / kGroup];
    g.players.emplace_back(seed, kPlayerStreams + i);
    restart(g, g.players.back());
  }
}

void Cflge::playAndLearn() {
  forGroups(groups_.size(),
            [&](size_t first, size_t count) { play(std::span(groups_).subspan(first, count)); });
  for (Group& g : groups_) {
    for (Episode& e : g.ended) take(e);
    for (Track& t : g.tracks) remember(std::move(t));
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

void Cflge::remember(Track track) {
  goals_.add(track.path);
  memory_.add(std::make_shared<const Track>(std::move(track)));
}

void Cflge::tryKnown(size_t first, size_t count) {
  LearnedSearch::tryKnown(first, count);
  for (size_t way = first; way < first + count; ++way) {
    Player p(seed(), kFollowers + way);
    begin(p);
    follow(p, actions(way));
    remember(endOf(p));
  }
}

// Replays a trajectory decision by decision. A decision's first action determines its move.
void Cflge::follow(Player& p, const KnownWay& way) {
  std::vector<float> inputs(kPolicyInputs);
  Episode* const episode = &p.episode;
  WayCursor cursor;
  for (uint32_t ticks = ticksOf(way); ticks > 0 && goesOn(p.episode);) {
    look(p, inputs.data());
    WayCursor ahead = cursor;
    p.track.moves.push_back(uint8_t(nearestMove(ahead.next(way), kNorth, true)));
    for (uint32_t k = 0; k < policy::kDecisionTicks && ticks > 0 && goesOn(p.episode); ++k) {
      const sim::Action action = cursor.next(way);
      advance({&episode, 1}, &action);
      count(1);
      --ticks;
    }
  }
}

// Takes learning steps in proportion to decisions. Ranks the goals again at longer intervals.
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
  goals_.refresh(allThreads(), module_, ranking_);
  ranked_ = decided_;
}

void Cflge::play(std::span<Group> groups) {
  const size_t count = groups.size() * kGroup;
  const auto player = [&](size_t i) -> Player& { return groups[i / kGroup].players[i % kGroup]; };
  std::vector<View> views(count);
  std::vector<float> inputs(count * kPolicyInputs);
  for (size_t i = 0; i < count; ++i) encode(groups[i / kGroup], player(i));
  for (uint32_t t = 0; t < settings_.decisions; ++t) {
    for (size_t i = 0; i < count; ++i) views[i] = lookFrom(player(i));
    see(views, inputs.data(), kPolicyInputs);
    for (size_t i = 0; i < count; ++i) note(player(i), inputs.data() + i * kPolicyInputs);
    const float* outputs = groups[0].pass.forward(policy_.net(), inputs.data(), count);
    for (size_t i = 0; i < count; ++i, outputs += size_t(policy::kMoves) * kQuantiles) {
      decide(player(i), outputs);
    }
    for (uint32_t k = 0; k < policy::kDecisionTicks; ++k) tick(groups);
    reach(groups);
    for (size_t i = 0; i < count; ++i) endDecision(groups[i / kGroup], player(i));
  }
}

// Returns the view toward the query's next region; the goal is a separate input.
View Cflge::lookFrom(const Player& p) const {
  return {&p.episode, *nextRegion(scene().query, p.episode.world).region, kNorth};
}

// Fills `inputs`, (kPolicyInputs), and records them, for a single player.
void Cflge::look(Player& p, float* inputs) {
  const View view = lookFrom(p);
  see({&view, 1}, inputs);
  note(p, inputs);
}

// Records the player's place, and the observation: the first policy::kInputs of `inputs`,
// (kPolicyInputs). Fills in the rest, the position of the goal.
void Cflge::note(Player& p, float* inputs) const {
  const sim::World& world = p.episode.world;
  const sim::LooseBody* const loose = p.episode.loose.data();
  float place[kPlace];
  placeOf(problem(), world, loose, place);
  p.path->places.insert(p.path->places.end(), place, place + kPlace);
  p.path->stands.push_back(grounded(world) && goesOn(p.episode));
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
  p.track.moves.push_back(uint8_t(nearestMove(p.action, kNorth, true)));
}

void Cflge::tick(std::span<Group> groups) {
  std::vector<Episode*> episodes;
  std::vector<sim::Action> held;
  for (Group& g : groups) {
    for (Player& p : g.players) {
      if (!goesOn(p.episode)) continue;
      episodes.push_back(&p.episode);
      held.push_back(allowed(p.action, p.episode.world));
      ++g.steps;
    }
  }
  advance(episodes, held.data());
}

// Moves players within reach of a sub-goal on to the next.
void Cflge::reach(std::span<Group> groups) {
  const size_t count = groups.size() * kGroup;
  std::vector<float>& places = groups[0].places;
  places.resize(count * kPlace);
  for (size_t i = 0; i < count; ++i) {
    const Episode& e = groups[i / kGroup].players[i % kGroup].episode;
    placeOf(problem(), e.world, e.loose.data(), places.data() + i * kPlace);
  }
  module_.encode(places.data(), count, groups[0].encoder, groups[0].points);
  const float* point = groups[0].points.data();
  for (size_t i = 0; i < count; ++i, point += kLatent) {
    Group& g = groups[i / kGroup];
    Player& p = g.players[i % kGroup];
    const auto reached = [&](size_t s) {
      return latentDistance2(point, p.points.data() + s * kLatent) <
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
  g.tracks.push_back(endOf(p));
  g.ended.push_back(std::move(p.episode));
  restart(g, p);
}

// Ends a track. An episode that reached the query's goal does not count as a death.
Track Cflge::endOf(Player& p) {
  float inputs[kPolicyInputs];
  look(p, inputs);
  p.track.ended = !goesOn(p.episode) && p.episode.world.outcome != sim::Outcome::goal;
  p.track.path = std::move(p.path);
  return std::move(p.track);
}

void Cflge::begin(Player& p) const {
  p.episode = LearnedSearch::begin();
  p.path = std::make_shared<Path>();
  p.track = {};
  p.next = p.count = 0;
  p.waited = p.explored = 0;
  p.keys.letGo();
  p.subgoals.clear();
}

// Starts an episode to a goal, with the thinned trajectory to it as sub-goals.
void Cflge::restart(Group& g, Player& p) {
  begin(p);
  if (goals_.empty()) return;
  const Goal& goal = goals_.draw(p.random);
  const float* const places = goal.path->place(0);
  module_.encode(places, goal.index + 1, g.encoder, g.points);
  const float* const points = g.points.data();
  const std::vector<uint32_t> kept = thinned(points, goal.index + 1, module_.reach());
  p.count = kept.size();
  for (const uint32_t i : kept) {
    p.subgoals.insert(p.subgoals.end(), places + i * kPlace, places + (i + 1) * kPlace);
  }
  encode(g, p);
  ++g.returns.tried;
}

// Encodes the sub-goals again. The module keeps learning during an episode, so earlier points would
// no longer match.
void Cflge::encode(Group& g, Player& p) const {
  if (p.count > 0) module_.encode(p.subgoals.data(), p.count, g.encoder, p.points);
}

}  // namespace obby::baselines

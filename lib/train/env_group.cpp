#include "train/env_group.h"

namespace obby::train {

uint64_t levelIndex(const EnvGroupSettings& settings, uint32_t envGroup, uint32_t envGroups,
                    uint32_t place, uint64_t taken) {
  const uint64_t all = uint64_t(envGroups) * settings.levels;
  return (taken - 1) * all + uint64_t(envGroup) * settings.levels + place;
}

EnvGroup::EnvGroup(const LevelSource& source, const EnvGroupSettings& settings, uint64_t seed,
                   uint32_t number, uint32_t envGroups)
    : source_(source),
      settings_(settings),
      seed_(seed),
      number_(number),
      envGroups_(envGroups),
      places_(settings.levels) {}

Status EnvGroup::begin(float hardest) {
  for (uint32_t p = 0; p < places_.size(); ++p) {
    places_[p].nextHardest = hardest;
    OBBY_RETURN_IF_ERROR(takeLevel(p, hardest));
    OBBY_RETURN_IF_ERROR(needLevel(p));
  }
  return {};
}

uint64_t EnvGroup::indexOf(uint32_t p, uint64_t taken) const {
  return levelIndex(settings_, number_, envGroups_, p, taken);
}

Status EnvGroup::findLevel(uint32_t p) {
  Place& place = places_[p];
  place.level = nullptr;
  OBBY_ASSIGN(place.level, source_.level(indexOf(p, place.taken), place.hardest));
  if (place.level) place.view = place.level->view(settings_.patience);
  return {};
}

Status EnvGroup::needLevel(uint32_t p) {
  return places_[p].level ? Status() : Status(makeError(kInterrupted));
}

Status EnvGroup::takeLevel(uint32_t p, float nextHardest) {
  Place& place = places_[p];
  ++place.taken;
  place.hardest = std::exchange(place.nextHardest, nextHardest);
  Status found = findLevel(p);
  beginPlace(place);
  return found;
}

void EnvGroup::beginPlace(Place& place) {
  place.counts = {};
  if (!place.level) {
    place.players.clear();
    place.bodies.clear();
    place.reached.clear();
    return;
  }
  place.players.resize(settings_.worlds);
  place.bodies.resize(size_t(settings_.worlds) * place.level->startBodies().size());
  place.reached.resize(kMaxReached);
  beginLevel(viewOf(place));
}

PlaceView EnvGroup::viewOf(Place& place) const {
  return {&place.view,   place.players.data(), place.bodies.data(),       place.reached.data(),
          &place.counts, settings_.worlds,     place.view.level.bodyCount};
}

sim::RigidBody* EnvGroup::bodiesOf(Place& place, uint32_t player) const {
  return place.view.level.bodyCount == 0 ? nullptr : viewOf(place).bodiesOf(player);
}

void EnvGroup::observe(float* rows, uint8_t* mayJump) {
  for (Place& place : places_) {
    const policy::Scene& scene = place.level->scene();
    for (uint32_t i = 0; i < settings_.worlds; ++i) {
      Player& p = place.players[i];
      p.ahead = settings_.observe(scene, p.world, bodiesOf(place, i), rows);
      *mayJump++ = policy::jumpAllowed(scene, p.world);
      rows += policy::kInputs;
    }
  }
}

void EnvGroup::advance(Place& place, std::span<const int> moves) {
  worlds_.clear();
  bodies_.clear();
  actions_.clear();
  for (uint32_t i = 0; i < settings_.worlds; ++i) {
    worlds_.push_back(&place.players[i].world);
    bodies_.push_back(bodiesOf(place, i));
    actions_.push_back(policy::actionOf(moves[i], place.players[i].ahead));
  }
  for (uint32_t t = 0; t < policy::kDecisionTicks; ++t) {
    sim::advanceAll(place.view.level, &place.view.query, worlds_, bodies_.data(), actions_.data());
  }
}

void EnvGroup::step(std::span<const int> moves, std::span<Step> steps) {
  for (uint32_t p = 0; p < places_.size(); ++p) {
    Place& place = places_[p];
    const uint32_t first = p * settings_.worlds;
    advance(place, moves.subspan(first, settings_.worlds));
    for (uint32_t i = 0; i < settings_.worlds; ++i)
      steps[first + i] = judge(place.view, settings_.reward, place.players[i]);
  }
}

void EnvGroup::settle(uint64_t decision, bool endOfIteration) {
  const SettleRules rules{seed_, settings_.restarts, decision, endOfIteration};
  for (uint32_t p = 0; p < places_.size(); ++p)
    train::settle(viewOf(places_[p]), rules, firstWorld() + p * settings_.worlds);
}

void EnvGroup::settle(uint64_t decision) { settle(decision, false); }

Status EnvGroup::settleIteration(uint64_t decision, float hardest) {
  settle(decision, true);
  Status said;  // the first error; all places end the iteration, so that training can resume
  for (uint32_t p = 0; p < places_.size(); ++p) {
    if (!isOver(places_[p].counts, settings_)) continue;
    tally_.add(places_[p].counts);
    Status taken = takeLevel(p, hardest);
    if (said) said = std::move(taken);
  }
  return said;
}

Tally EnvGroup::takeTally() {
  for (Place& place : places_) tally_.add(place.counts);
  return std::exchange(tally_, {});
}

}  // namespace obby::train

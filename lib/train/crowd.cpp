#include "train/crowd.h"

#include <algorithm>
#include <utility>

#include "policy/policy.h"

namespace obby::train {

namespace {

constexpr uint32_t kRememberEvery = 64;  // about one state in so many decisions

}  // namespace

Crowd::Crowd(const LevelSource& source, const CrowdSettings& settings, uint64_t seed,
             uint32_t number, uint32_t crowds)
    : source_(source),
      settings_(settings),
      random_(seed, number),
      number_(number),
      crowds_(crowds),
      places_(settings.levels) {}

Status Crowd::begin() {
  for (uint32_t p = 0; p < places_.size(); ++p) OBBY_RETURN_IF_ERROR(takeLevel(p));
  return {};
}

uint64_t Crowd::indexOf(uint32_t p, uint64_t taken) const {
  const uint64_t all = uint64_t(crowds_) * places_.size();
  return (taken - 1) * all + uint64_t(number_) * places_.size() + p;
}

Status Crowd::findLevel(uint32_t p) {
  Place& place = places_[p];
  OBBY_ASSIGN(place.level, source_.level(indexOf(p, place.taken), place.hardest));
  place.mostTicks = mostTicksOf(*place.level, settings_.patience);
  return {};
}

Status Crowd::takeLevel(uint32_t p) {
  Place& place = places_[p];
  ++place.taken;
  place.hardest = hardest_;
  OBBY_RETURN_IF_ERROR(findLevel(p));
  place.played = 0;
  place.reached.clear();
  place.players.assign(settings_.worlds, {});
  place.loose.assign(size_t(settings_.worlds) * place.level->startLoose().size(), {});
  for (uint32_t i = 0; i < settings_.worlds; ++i) restart(place, i);
  return {};
}

sim::LooseBody* Crowd::looseOf(Place& place, uint32_t player) const {
  const size_t count = place.level->startLoose().size();
  return count == 0 ? nullptr : place.loose.data() + player * count;
}

void Crowd::restart(Place& place, uint32_t player) {
  Player& p = place.players[player];
  const bool elsewhere = !place.reached.empty() && random_.unit() < settings_.restartShare;
  p.world = elsewhere ? place.reached[random_.below(uint32_t(place.reached.size()))]
                      : place.level->start();
  p.fromStart = !elsewhere;
  p.least = place.level->guide().left(p.world.position);
  p.ticks = 0;
  const auto& loose = place.level->startLoose();
  std::copy(loose.begin(), loose.end(), place.loose.begin() + ptrdiff_t(player * loose.size()));
}

// States in which the player stands; bodies are not kept, so levels with such begin at the start.
void Crowd::remember(Place& place, const sim::World& world) {
  if (random_.below(kRememberEvery) != 0) return;
  if (world.floorlessTicks != 0 || !place.level->startLoose().empty()) return;
  if (place.reached.size() < kMostReached) {
    place.reached.push_back(world);
  } else {
    place.reached[random_.below(kMostReached)] = world;
  }
}

void Crowd::observe(float* rows, uint8_t* mayJump) {
  for (Place& place : places_) {
    const policy::Scene& scene = place.level->scene();
    for (uint32_t i = 0; i < settings_.worlds; ++i) {
      Player& p = place.players[i];
      p.ahead = policy::observe(scene, p.world, looseOf(place, i), rows);
      *mayJump++ = policy::jumpAllowed(scene, p.world);
      rows += policy::kInputs;
    }
  }
}

void Crowd::advance(Place& place, std::span<const int> moves) {
  worlds_.clear();
  loose_.clear();
  actions_.clear();
  for (uint32_t i = 0; i < settings_.worlds; ++i) {
    worlds_.push_back(&place.players[i].world);
    loose_.push_back(looseOf(place, i));
    actions_.push_back(policy::actionOf(moves[i], place.players[i].ahead));
  }
  const policy::Scene& scene = place.level->scene();
  for (uint32_t t = 0; t < policy::kDecisionTicks; ++t) {
    sim::advanceAll(scene.level, &scene.query, worlds_, loose_.data(), actions_.data());
  }
}

Step Crowd::judge(Place& place, uint32_t player) {
  Player& p = place.players[player];
  const RewardSettings& worth = settings_.reward;
  Step step;
  step.reward = worth.decision;
  const float left = place.level->guide().left(p.world.position);
  if (left < p.least) {
    step.reward += worth.stud * (p.least - left);
    p.least = left;
  }
  p.ticks += policy::kDecisionTicks;
  step.ended = p.world.outcome != sim::Outcome::running;
  step.cut = !step.ended && p.ticks >= place.mostTicks;
  const bool solved = p.world.outcome == sim::Outcome::goal;
  if (step.ended) step.reward += solved ? worth.goal : worth.death;
  if (!step.ended && !step.cut) return step;
  ++place.played;
  if (!p.fromStart) return step;
  ++tally_.played;
  tally_.solved += solved;
  return step;
}

void Crowd::noteCut(Place& place, uint32_t player, uint32_t row) {
  cutWorlds_.push_back(row);
  cutRows_.resize(cutRows_.size() + policy::kInputs);
  policy::observe(place.level->scene(), place.players[player].world, looseOf(place, player),
                  cutRows_.data() + cutRows_.size() - policy::kInputs);
}

Status Crowd::step(std::span<const int> moves, std::span<Step> steps) {
  cutRows_.clear();
  cutWorlds_.clear();
  for (uint32_t p = 0; p < places_.size(); ++p) {
    Place& place = places_[p];
    const uint32_t first = p * settings_.worlds;
    advance(place, moves.subspan(first, settings_.worlds));
    for (uint32_t i = 0; i < settings_.worlds; ++i) steps[first + i] = judge(place, i);
    const bool over = place.played >= settings_.playthroughs;
    for (uint32_t i = 0; i < settings_.worlds; ++i) {
      Step& s = steps[first + i];
      s.cut = s.cut || (over && !s.ended);
      if (s.cut) noteCut(place, i, first + i);
      if (s.ended || s.cut) {
        if (!over) restart(place, i);
      } else {
        remember(place, place.players[i].world);
      }
    }
    if (over) OBBY_RETURN_IF_ERROR(takeLevel(p));
  }
  return {};
}

}  // namespace obby::train

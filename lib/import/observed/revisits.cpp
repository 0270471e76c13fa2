#include "import/observed/revisits.h"

#include <algorithm>

#include "import/motion.h"

namespace obby::importer {
namespace {

template <class T>
std::vector<T> partsWithout(const std::vector<T>& all, const std::vector<T>& known) {
  std::vector<T> rest;
  for (const T& one : all)
    if (std::none_of(known.begin(), known.end(),
                     [&](const T& other) { return other.part == one.part; }))
      rest.push_back(one);
  return rest;
}

// A click detector or a prompt goes by the name of its part.
const std::string& partNear(const Tree& tree, InstanceId lever) {
  const InstanceId parent = tree.at(lever).parent;
  const bool hasParent = !tree.isPart(lever) && parent < tree.size();
  return hasParent ? tree.at(parent).name : tree.at(lever).name;
}

}  // namespace

bool ProbeEffects::onlyStage() const {
  ProbeEffects rest = *this;
  rest.stage.reset();
  rest.won.reset();
  return rest.empty();
}

std::optional<ProbeEffects> ProbeEffects::asOf(InstanceId from, InstanceId to) const {
  ProbeEffects other = *this;
  if (teleport || !moved.empty() || !belts.empty() || !sizes.empty()) return std::nullopt;
  for (std::vector<Away>* const parts : {&other.aways, &other.backs})
    for (Away& away : *parts) {
      if (away.part != from) return std::nullopt;
      away.part = to;
    }
  if (other.stage) other.stage = StageSet{{}, {}, kNoInstance, other.stage->line};
  return other;
}

engine::Line ProbeEffects::line() const {
  if (harm) return harm->line;
  if (push) return push->line;
  if (teleport) return teleport->line;
  if (boost) return boost->line;
  if (trips) return tripLine;
  for (const auto& one : {force, jumps})
    if (one) return *one;
  if (!aways.empty()) return aways[0].line;
  if (!backs.empty()) return backs[0].line;
  if (!moved.empty()) return moved[0].line;
  if (won) return *won;
  return stage ? stage->line : engine::Line{};
}

ProbeEffects addedIn(const ProbeEffects& before, const ProbeEffects& now) {
  ProbeEffects added;
  if (!before.harm) added.harm = now.harm;
  if (!before.push) added.push = now.push;
  if (!before.teleport) added.teleport = now.teleport;
  if (!before.boost) added.boost = now.boost;
  if (!before.stage) added.stage = now.stage;
  if (!before.won) added.won = now.won;
  if (!before.force) added.force = now.force;
  added.trips = now.trips && !before.trips;
  added.tripLine = now.tripLine;
  added.aways = partsWithout(now.aways, before.aways);
  added.backs = partsWithout(now.backs, before.backs);
  // A toggle: what went away comes back.
  added.backs = partsWithout(added.backs, before.aways);
  added.aways = partsWithout(added.aways, before.backs);
  added.moved = partsWithout(now.moved, before.moved);
  return added;
}

ProbeEffects endedIn(const ProbeEffects& before, const ProbeEffects& now) {
  ProbeEffects ended = addedIn(now, before);
  const auto stays = [](const Away& away) { return !away.seconds; };
  std::erase_if(ended.aways, stays);
  std::erase_if(ended.backs, stays);
  std::erase_if(ended.moved, [](const Moved& moved) {
    return !samePose(moved.poses.front(), moved.poses.back());
  });
  ended.stage.reset();
  ended.won.reset();
  if (ended.boost && ended.boost->forever) ended.boost.reset();
  return ended;
}

std::string whenOf(const Tree& tree, const engine::Revisit& revisit) {
  switch (revisit.cause) {
    case engine::Cause::again: return "from its second touch on";
    case engine::Cause::time: return "at some times";
    case engine::Cause::lever:
      if (revisit.lever < tree.size())
        return "once '" + partNear(tree, revisit.lever) + "' has been touched or used";
      break;
    case engine::Cause::several: break;
  }
  return "once other parts have been touched or used";
}

}  // namespace obby::importer

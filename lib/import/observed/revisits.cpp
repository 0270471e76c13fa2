#include "import/observed/revisits.h"

#include <algorithm>

#include "import/draft/motion.h"

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

engine::Line lineOf(engine::Line line) { return line; }
template <class Effect>
engine::Line lineOf(const Effect& effect) {
  return effect.line;
}

// Calls `each` with the members of both tuples, pairwise.
template <class... A, class... B, class Each>
void zip(std::tuple<A&...> a, std::tuple<B&...> b, const Each& each) {
  const auto at = [&]<size_t... i>(std::index_sequence<i...>) {
    (each(std::get<i>(a), std::get<i>(b)), ...);
  };
  at(std::index_sequence_for<A...>{});
}

// Returns the name of a lever, or that of its part if the lever is a click detector or a prompt.
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
  engine::Line found;
  const auto takeFirst = [&](const auto& effect) {
    if (found == engine::Line{} && effect) found = lineOf(*effect);
  };
  std::apply([&](const auto&... effect) { (takeFirst(effect), ...); }, onPlayer());
  const auto takeParts = [&](const auto& parts) {
    if (found == engine::Line{} && !parts.empty()) found = parts[0].line;
  };
  std::apply([&](const auto&... parts) { (takeParts(parts), ...); }, onParts());
  return found;
}

ProbeEffects addedIn(const ProbeEffects& before, const ProbeEffects& now) {
  ProbeEffects added = now;
  zip(added.onPlayer(), before.onPlayer(), [](auto& effect, const auto& old) {
    if (old) effect.reset();
  });
  zip(added.onParts(), before.onParts(),
      [](auto& parts, const auto& old) { parts = partsWithout(parts, old); });
  // A toggle brings back parts that were away.
  added.backs = partsWithout(added.backs, before.aways);
  added.aways = partsWithout(added.aways, before.backs);
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
    case engine::Cause::again: return "from the second touch on";
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

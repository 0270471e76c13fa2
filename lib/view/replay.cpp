// Replay through sim, and the comparison with the record.
#include "view/replay.h"

#include <fmt/format.h>

#include <algorithm>

#include "sim/simulator.h"

namespace obby::view {
namespace {

// Parts behind the role table, where touch makes them vanish.
std::vector<uint32_t> vanishingParts(const level::LevelView& view) {
  std::vector<uint32_t> parts;
  for (uint32_t i = 0; i < view.colliderCount; ++i) {
    if ((view.bounds[i].flags & level::kVanishTouch) == 0) continue;
    const level::Collider& collider = view.colliders[i];
    if (collider.role >= parts.size()) parts.resize(collider.role + 1, level::kNone);
    parts[collider.role] = collider.part;
  }
  return parts;
}

std::vector<uint32_t> awayParts(const sim::World& world, const level::LevelView& view,
                                const std::vector<uint32_t>& partOfRole) {
  std::vector<uint32_t> away;
  for (int i = 0; i < world.vanishingCount; ++i) {
    const sim::Vanishing& v = world.vanishing[i];
    if (v.role < partOfRole.size() && v.ticks >= view.roles[v.role].vanishDelay) {
      away.push_back(partOfRole[v.role]);
    }
  }
  std::sort(away.begin(), away.end());
  return away;
}

std::vector<PartEvent> eventsOf(const std::vector<sim::World>& worlds,
                                const level::LevelView& view) {
  std::vector<PartEvent> events;
  const std::vector<uint32_t> partOfRole = vanishingParts(view);
  if (partOfRole.empty()) return events;
  std::vector<uint32_t> before;
  for (uint32_t tick = 0; tick < worlds.size(); ++tick) {
    std::vector<uint32_t> now = awayParts(worlds[tick], view, partOfRole);
    for (const uint32_t part : now) {
      if (!std::binary_search(before.begin(), before.end(), part)) {
        events.push_back({tick, part, false});
      }
    }
    for (const uint32_t part : before) {
      if (!std::binary_search(now.begin(), now.end(), part)) events.push_back({tick, part, true});
    }
    before = std::move(now);
  }
  return events;
}

std::string name(schema::Outcome outcome) {
  constexpr const char* kNames[] = {"running", "goal",  "killed", "fell",
                                    "avoided", "jumps", "timeout"};
  const auto index = size_t(outcome);
  return index < std::size(kNames) ? kNames[index] : fmt::format("outcome {}", index);
}

std::string compare(const Playback& replay, uint64_t hash,
                    schema::Trajectory::Reader record, bool withQuery) {
  // Without its query, an end that a region or a limit makes cannot come about.
  const bool comparable = withQuery || record.getOutcome() == schema::Outcome::KILLED ||
                          record.getOutcome() == schema::Outcome::FELL;
  if (comparable && replay.outcome != record.getOutcome()) {
    return fmt::format("recorded as {}, replayed as {}", name(record.getOutcome()),
                       name(replay.outcome));
  }
  if (comparable && replay.ticks() != record.getTicks()) {
    return fmt::format("recorded {} ticks, replayed {}", record.getTicks(), replay.ticks());
  }
  if (withQuery && record.getStateHash() != 0 && hash != record.getStateHash()) {
    return fmt::format("the last state differs from the recorded one ({:016x}, recorded {:016x})",
                       hash, record.getStateHash());
  }
  return {};
}

}  // namespace

Result<Playback> playBack(const level::Level& level, const level::Query* query,
                          schema::Trajectory::Reader record) {
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(record));
  level::QueryView rules{};
  if (query != nullptr) rules = query->view();
  const sim::Replay replay =
      sim::replay(level.view(), query != nullptr ? &rules : nullptr, plan);
  const std::vector<sim::World>& worlds = replay.worlds;
  Playback out;
  for (const sim::World& world : worlds) {
    const bool airborne = world.state == sim::State::jumping || world.state == sim::State::freefall;
    out.feet.push_back(world.position);
    out.yaw.push_back(world.yaw);
    out.state.push_back(
        uint8_t((airborne ? kAirborne : 0) | (world.state == sim::State::dead ? kDead : 0)));
  }
  for (uint32_t tick = 1; tick < worlds.size(); ++tick) {
    if (worlds[tick].jumps > worlds[tick - 1].jumps) out.jumpTicks.push_back(tick);
  }
  const sim::World& last = worlds.back();
  const uint64_t hash = sim::stateHash(last, replay.looseAt(worlds.size() - 1));
  out.events = eventsOf(worlds, level.view());
  out.outcome = schema::Outcome(uint16_t(last.outcome));
  out.part = last.part == level::kNone ? -1 : int32_t(last.part);
  out.mismatch = compare(out, hash, record, query != nullptr);
  return out;
}

}  // namespace obby::view

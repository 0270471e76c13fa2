// Replay through sim, and the comparison with the record.
#include "view/replay.h"

#include <fmt/format.h>

#include <utility>

#include "sim/simulator.h"
#include "view/enum_name.h"

namespace obby::view {
namespace {

std::string compare(const Playback& replay, uint64_t hash, schema::Trajectory::Reader record,
                    bool withQuery) {
  // Without its query, an end that a region or a limit makes cannot come about.
  const bool comparable = withQuery || record.getOutcome() == schema::Outcome::KILLED ||
                          record.getOutcome() == schema::Outcome::FELL;
  if (comparable && replay.outcome != record.getOutcome()) {
    return fmt::format("recorded as {}, replayed as {}", enumName(record.getOutcome()),
                       enumName(replay.outcome));
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
  const sim::Replay replay = sim::replay(level.view(), query != nullptr ? &rules : nullptr, plan);
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
  PartEvents parts = partEventsOf(worlds, level.view());
  out.events = std::move(parts.events);
  out.motions = std::move(parts.motions);
  out.partsCut = parts.cut;
  out.loose = looseTracksOf(replay, level.view());
  out.outcome = schema::Outcome(uint16_t(last.outcome));
  out.part = last.part == level::kNone ? -1 : int32_t(last.part);
  out.mismatch = compare(out, hash, record, query != nullptr);
  return out;
}

}  // namespace obby::view

// Replays trajectories and compares them with their records.
#include "view/replay.h"

#include <fmt/format.h>

#include <utility>

#include "sim/simulator.h"
#include "view/enum_name.h"

namespace obby::view {
namespace {

std::string compare(const Playback& replay, uint64_t hash, schema::Trajectory::Reader record,
                    bool withQuery) {
  // Without the query, the replay cannot end at a region or a limit.
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
    return fmt::format(
        "the last state differs from the recorded one (hash {:016x}, recorded {:016x})", hash,
        record.getStateHash());
  }
  return {};
}

void add(const sim::Moment& now, Playback& to) {
  const sim::World& world = now.world;
  const bool airborne = world.state == sim::State::jumping || world.state == sim::State::freefall;
  to.feet.push_back(world.position);
  to.yaw.push_back(world.yaw);
  to.state.push_back(
      uint8_t((airborne ? kAirborne : 0) | (world.state == sim::State::dead ? kDead : 0)));
  if (world.jumps > now.before.jumps) to.jumpTicks.push_back(now.tick);
}

}  // namespace

Result<Playback> playBack(const level::Level& level, const level::Query* query,
                          schema::Trajectory::Reader record) {
  OBBY_ASSIGN(const sim::Plan plan, sim::planFromRecord(record));
  level::QueryView rules{};
  if (query != nullptr) rules = query->view();
  Playback out;
  PartWatch parts(level.view());
  BodyWatch bodies(level.view());
  const auto see = [&](const sim::Moment& now) {
    add(now, out);
    parts.see(now);
    bodies.see(now);
    return true;
  };
  const sim::ReplayEnd end =
      sim::replay(level.view(), query != nullptr ? &rules : nullptr, plan, see);
  PartEvents events = parts.take();
  out.events = std::move(events.events);
  out.motions = std::move(events.motions);
  out.partsCut = events.cut;
  out.bodies = bodies.tracks();
  out.outcome = schema::Outcome(uint16_t(end.world.outcome));
  out.part = end.world.part == level::kNone ? -1 : int32_t(end.world.part);
  out.mismatch = compare(out, sim::stateHash(end.world, end.bodies), record, query != nullptr);
  return out;
}

}  // namespace obby::view

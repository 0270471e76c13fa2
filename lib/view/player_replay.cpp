#include "view/player_replay.h"

#include <algorithm>
#include <vector>

#include "view/entries.h"

namespace obby::view {
namespace {

// Samples of a trajectory at another tick rate, including the last tick.
struct TickSamples {
  uint32_t ticks, from, to;

  uint32_t count() const { return level::nextTickAtRate(ticks, from, to) + 1; }
  double at(uint32_t sample) const { return std::min(double(sample) * from / to, double(ticks)); }

  template <class T>
  std::vector<T> of(const std::vector<T>& all) const {
    std::vector<T> out;
    for (uint32_t i = 0; i < count(); ++i) out.push_back(all[size_t(at(i))]);
    return out;
  }
};

std::vector<Vec3> placesOf(const std::vector<Vec3>& feet, const TickSamples& samples) {
  std::vector<Vec3> out;
  for (uint32_t i = 0; i < samples.count(); ++i) {
    const double at = samples.at(i);
    const size_t tick = size_t(at);
    const size_t next = std::min(tick + 1, feet.size() - 1);
    out.push_back(feet[tick] + (feet[next] - feet[tick]) * float(at - double(tick)));
  }
  return out;
}

// Keeps the last of several samples in one tick.
BodyTrack resampled(const BodyTrack& track, uint32_t from, uint32_t to) {
  BodyTrack out;
  out.part = track.part;
  for (size_t i = 0; i < track.ticks.size(); ++i) {
    const uint32_t tick = level::nextTickAtRate(track.ticks[i], from, to);
    const bool last =
        i + 1 == track.ticks.size() || level::nextTickAtRate(track.ticks[i + 1], from, to) != tick;
    if (!last) continue;
    out.ticks.push_back(tick);
    const auto copy = [i](auto& all, const auto& of, size_t size) {
      if (!of.empty()) all.insert(all.end(), &of[i * size], &of[i * size] + size);
    };
    copy(out.positions, track.positions, 3);
    copy(out.rotations, track.rotations, 4);
  }
  return out;
}

io::Record resampled(schema::Trajectory::Reader record, uint32_t from, uint32_t to) {
  io::RecordBuilder copy;
  copy.root().setTrajectory(record);
  auto t = copy.root().getTrajectory();
  const auto next = [&](uint32_t tick) { return level::nextTickAtRate(tick, from, to); };
  t.setStartTick(level::tickAtRate(t.getStartTick(), from, to));
  t.setTicks(next(t.getTicks()));
  uint32_t end = 0, toEnd = 0;
  for (auto run : t.getActions()) {
    end += run.getTicks();
    run.setTicks(next(end) - toEnd);
    toEnd += run.getTicks();
  }
  for (auto step : t.getDifficulty().getSteps()) {
    const uint32_t last = next(step.getStartTick() + step.getTicks());
    step.setStartTick(next(step.getStartTick()));
    step.setTicks(last - step.getStartTick());
  }
  return io::Record(std::move(copy));
}

Result<level::Query> queryAtRate(const QueryEntry& entry, const level::Level& level,
                                 uint16_t from) {
  io::RecordBuilder copy(entry.query->reader());
  level::setRate(from, level.view().params.controlRate, copy.root().getQuery());
  return level::Query::compile(copy.reader().getQuery(), level);
}

}  // namespace

Playback resampled(Playback playback, uint32_t from, uint32_t to) {
  const TickSamples samples{playback.ticks(), from, to};
  const auto next = [&](uint32_t tick) { return level::nextTickAtRate(tick, from, to); };
  playback.feet = placesOf(playback.feet, samples);
  playback.yaw = samples.of(playback.yaw);
  playback.state = samples.of(playback.state);
  for (uint32_t& tick : playback.jumpTicks) tick = next(tick);
  for (PartEvent& event : playback.events) event.tick = next(event.tick);
  for (MotionEvent& event : playback.motions) {
    event.tick = next(event.tick);
    if (event.start != kRests) event.start = event.start * to / from;
  }
  for (BodyTrack& track : playback.bodies) track = resampled(track, from, to);
  return playback;
}

Result<const level::Level*> PlayerReplays::levelFor(const LevelEntry& level, int index,
                                                    const level::Player& player) {
  auto& known = levels_[{index, player}];
  if (!known) {
    io::RecordBuilder copy(level.record.reader());
    OBBY_RETURN_IF_ERROR(level::setPlayer(player, copy.root().getLevel()));
    OBBY_ASSIGN(level::Level compiled, level::Level::compile(copy.reader().getLevel()));
    known = std::make_unique<const level::Level>(std::move(compiled));
  }
  return known.get();
}

Result<PlayerReplays::Replayed> PlayerReplays::play(const LevelEntry& level, int index,
                                                    const QueryEntry& query,
                                                    schema::Trajectory::Reader record) {
  OBBY_ASSIGN(const level::Player player, level::playerOf(record));
  if (player.isLevels()) {
    OBBY_ASSIGN(Playback own, playBack(*level.level, query.compiled.get(), record));
    return Replayed{std::move(own), {}};
  }
  OBBY_ASSIGN(const level::Level* const played, levelFor(level, index, player));
  const uint16_t to = level.level->view().params.controlRate;
  const uint16_t from = played->view().params.controlRate;
  std::optional<level::Query> rules;
  if (query.compiled) {
    OBBY_ASSIGN(rules, queryAtRate(query, *played, to));
  }
  OBBY_ASSIGN(Playback own, playBack(*played, rules ? &*rules : nullptr, record));
  if (from == to) return Replayed{std::move(own), {}};
  return Replayed{resampled(std::move(own), from, to), resampled(record, from, to)};
}

}  // namespace obby::view

#include "calibrate/fidelity.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"
#include "calibrate/frame_play.h"
#include "calibrate/playback.h"
#include "io/physics.h"

namespace obby::calibrate {

namespace {

// Returns the steps of the shortest tick that covers the longest frame and divides a second evenly,
// or 0 if there is none.
uint32_t longestTick(const std::vector<uint32_t>& steps, uint32_t stepsPerSecond) {
  if (steps.empty()) return 0;
  for (uint32_t n = *std::max_element(steps.begin(), steps.end()); n <= kMaxSteps; ++n) {
    if (stepsPerSecond % n == 0) return n;
  }
  return 0;
}

// The level is compiled with the longest ticks, so that broad-phase searches cover every frame.
Result<level::Level> levelOfFrames(const Take& take, schema::PhysicsParams::Reader params,
                                   uint32_t stepsPerSecond, uint32_t longest) {
  io::RecordBuilder record(take.level.reader());
  auto level = record.root().getLevel();
  io::applyParams(params, level);
  auto physics = level.hasPhysics() ? level.getPhysics() : level.initPhysics();
  physics.setSubsteps(uint16_t(longest));
  physics.setControlRate(uint16_t(stepsPerSecond / longest));
  return level::Level::compile(level.asReader());
}

std::vector<Played> playTicks(const level::LevelView& view, const Track& track) {
  std::vector<Played> out{{track.frames[0].position, track.frames[0].state}};
  playBack(view, track, {{0, uint32_t(track.frames.size()) - 1}}, 0,
           [&](uint32_t, uint32_t, const Moment& now) {
             out.push_back({now.position, now.state});
           });
  return out;
}

Result<std::vector<Played>> play(const Take& take, schema::PhysicsParams::Reader params,
                                 uint16_t tricks, const MassCentre& centre) {
  OBBY_ASSIGN(const level::Level level, levelWith(take, params));
  const Params& p = level.view().params;
  const uint32_t rate = uint32_t(p.controlRate) * p.substeps;
  const std::vector<uint32_t> steps = stepsOf(take.track, double(rate));
  const uint32_t longest = longestTick(steps, rate);
  const auto viewOf = [&](const level::Level& of) {
    level::LevelView view = of.view();
    view.params.tricks = tricks;
    return view;
  };
  if (longest == 0 || level.view().moverCount > 0) return playTicks(viewOf(level), take.track);
  OBBY_ASSIGN(const level::Level framed, levelOfFrames(take, params, rate, longest));
  return playFrames(viewOf(framed), take.track, steps, centre);
}

bool changes(const std::vector<Played>& played, size_t frame, sim::State to) {
  return frame >= 1 && frame < played.size() && played[frame].state == to &&
         played[frame - 1].state != to;
}

void countEvents(const Track& track, const std::vector<Played>& played, Fidelity& out) {
  for (size_t i = 1; i < track.frames.size(); ++i) {
    const sim::State to = track.frames[i].state;
    if (to == track.frames[i - 1].state) continue;
    ++out.events;
    out.matched +=
        changes(played, i - 1, to) || changes(played, i, to) || changes(played, i + 1, to);
  }
}

constexpr float kLeap = 1;  // min studs of an apex above the lower end of the recording

// Returns the error of the apex height, studs. Returns nothing if the recording is highest at one
// of its ends, or if the apex is less than kLeap above its lower end.
std::optional<double> apexError(const Track& track, const std::vector<Played>& played) {
  const auto& frames = track.frames;
  const auto recorded =
      std::max_element(frames.begin(), frames.end(),
                       [](const Frame& a, const Frame& b) { return a.position.y < b.position.y; });
  if (recorded == frames.begin() || recorded + 1 == frames.end()) return std::nullopt;
  const float top = recorded->position.y;
  if (top - std::min(frames.front().position.y, frames.back().position.y) < kLeap)
    return std::nullopt;
  float simulated = played[0].position.y;
  for (const Played& p : played) simulated = std::max(simulated, p.position.y);
  return std::abs(double(simulated - top));
}

}  // namespace

Result<Fidelity> fidelityOf(const Take& take, schema::PhysicsParams::Reader params, uint16_t tricks,
                            const MassCentre& centre) {
  OBBY_ASSIGN(const std::vector<Played> played, play(take, params, tricks, centre));
  const Track& track = take.track;
  Fidelity out;
  out.frames = uint32_t(track.frames.size()) - 1;
  for (size_t i = 1; i < track.frames.size(); ++i) {
    const double off = double(length(played[i].position - track.frames[i].position));
    out.mean += off / double(out.frames);
    out.max = std::max(out.max, off);
  }
  countEvents(track, played, out);
  out.apex = apexError(track, played);
  return out;
}

FidelitySummary summaryOf(std::span<const Fidelity> all) {
  std::vector<double> means, apexes;
  uint64_t events = 0, matched = 0;
  for (const Fidelity& f : all) {
    means.push_back(f.mean);
    if (f.apex) apexes.push_back(*f.apex);
    events += f.events;
    matched += f.matched;
  }
  FidelitySummary out;
  out.medianMean = quantile(means, 0.5);
  out.p95Mean = quantile(means, 0.95);
  if (events > 0) out.matched = double(matched) / double(events);
  if (!apexes.empty()) out.medianApex = quantile(apexes, 0.5);
  return out;
}

}  // namespace obby::calibrate

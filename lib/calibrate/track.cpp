#include "calibrate/track.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "level/record_values.h"

namespace obby::calibrate {

namespace {

constexpr float kMinMove = 0.1f;
constexpr float kRising = 5;  // studs/s: faster upward motion is not walking
// Max seconds between two frames. The events of a longer pause are unknown, and playing it takes
// that long.
constexpr double kLongestGap = 10;
constexpr double kApart = 1e-6;   // seconds: closer frames count as simultaneous
constexpr float kFastest = 1e5f;  // studs/s: the simulation must not overflow

using level::vec;

// Returns false for NaN.
bool within(Vec3 v, float max) { return absf(v.x) <= max && absf(v.y) <= max && absf(v.z) <= max; }

Error inFrame(uint32_t i, std::string what, std::string cure) {
  return Error{{}, {}, fmt::format("frames[{}]", i), std::move(what), std::move(cure)};
}

}  // namespace

sim::State stateOf(const std::string& name, Vec3 velocity) {
  static constexpr std::pair<const char*, sim::State> kNames[] = {
      {"Running", sim::State::running},       {"RunningNoPhysics", sim::State::running},
      {"Landed", sim::State::landed},         {"Jumping", sim::State::jumping},
      {"Freefall", sim::State::freefall},     {"Climbing", sim::State::climbing},
      {"Seated", sim::State::seated},         {"FallingDown", sim::State::fallingDown},
      {"GettingUp", sim::State::fallingDown}, {"Ragdoll", sim::State::fallingDown},
      {"Physics", sim::State::freefall},      {"Dead", sim::State::dead}};
  for (const auto& [text, state] : kNames) {
    if (name == text) return state;
  }
  if (std::fabs(velocity.y) <= kRising) return sim::State::running;
  return velocity.y > 0 ? sim::State::jumping : sim::State::freefall;
}

const char* nameOf(sim::State state) {
  switch (state) {
    case sim::State::running: return "Running";
    case sim::State::jumping: return "Jumping";
    case sim::State::freefall: return "Freefall";
    case sim::State::landed: return "Landed";
    case sim::State::climbing: return "Climbing";
    case sim::State::seated: return "Seated";
    case sim::State::fallingDown: return "FallingDown";
    case sim::State::dead: break;
  }
  return "Dead";
}

Vec3 rootOf(Vec3 feet, const Params& p) {
  return feet + Vec3{0, p.hipHeight + 0.5f * p.rootHeight, 0};
}

Vec3 feetOf(const Frame& frame, const Params& p) {
  return frame.position - Vec3{0, p.hipHeight + 0.5f * p.rootHeight, 0};
}

sim::Action actionOf(const Frame& frame) {
  const bool walk = frame.move.x * frame.move.x + frame.move.z * frame.move.z > kMinMove * kMinMove;
  return {walk ? headingOf(frame.move.x, frame.move.z) : Turns(0), walk, frame.jump};
}

namespace {

Frame frameOf(schema::RecordingFrame::Reader f) {
  Vec3 facing = vec(f.getFacing());
  facing.y = 0;
  if (const float size = length(facing); size > 0 && std::isfinite(size))
    facing = facing * (1 / size);
  return {f.getTime(),
          vec(f.getMove()),
          f.getJump(),
          vec(f.getPosition()),
          vec(f.getVelocity()),
          stateOf(f.getState(), vec(f.getVelocity())),
          facing};
}

// Rejects values that are not finite, or too large for the simulator.
Status checkNumbers(const Frame& f, uint32_t number) {
  constexpr float kLongestMove = 1e3f;
  const bool sound = std::isfinite(f.time) && within(f.move, kLongestMove) &&
                     within(f.position, level::kMaxCoordinate) && within(f.velocity, kFastest) &&
                     level::isFinite(f.facing);
  if (sound) return {};
  return inFrame(number, "a number is not finite, or is out of range",
                 "use studs and studs/s; leave out bad frames");
}

// Checks the frame's time against the frame before.
Status checkTime(const Frame& frame, uint32_t number, const Track& track) {
  if (track.frames.empty()) return {};
  const double before = track.frames.back().time;
  if (frame.time < before)
    return inFrame(
        number, fmt::format("time {} is earlier than the previous frame's, {}", frame.time, before),
        "sort the frames by time");
  if (frame.time - before > kLongestGap)
    return inFrame(
        number,
        fmt::format("the frame is {:.6g} s after the previous one, expected at most {:.6g} s",
                    frame.time - before, kLongestGap),
        "give times in seconds; split a recording that has a pause into two");
  return {};
}

// A frame without poses repeats those of the frame before.
Status addPoses(schema::RecordingFrame::Reader frame, uint32_t number, Track& track) {
  const auto poses = frame.getPoses();
  const size_t count = track.shown.size();
  if (poses.size() == 0 && !track.poses.empty()) {
    for (size_t i = 0; i < count; ++i)
      track.poses.push_back(track.poses[track.poses.size() - count]);
    return {};
  }
  if (poses.size() != count)
    return inFrame(
        number, fmt::format("found {} poses for {} parts", poses.size(), count),
        "give one pose for each part of the recording, or no poses if no part has moved");
  for (const auto pose : poses) {
    const auto q = pose.getRotation();
    const PartPose to{vec(pose.getPosition()),
                      normalize(Quat{q.getX(), q.getY(), q.getZ(), q.getW()})};
    if (!within(to.position, level::kMaxCoordinate) || !std::isfinite(to.rotation.w))
      return inFrame(number, "a number of a pose is not finite, or is out of range",
                     "leave out bad frames");
    track.poses.push_back(to);
  }
  return {};
}

// Merges a frame into the previous one, which has the same time. The new input and poses replace
// the earlier ones.
Status addAgain(const Frame& frame, schema::RecordingFrame::Reader record, uint32_t number,
                Track& track) {
  track.frames.back().move = frame.move;
  track.frames.back().jump = frame.jump;
  if (record.getPoses().size() == 0) return {};
  track.poses.erase(track.poses.end() - std::ptrdiff_t(track.shown.size()), track.poses.end());
  return addPoses(record, number, track);
}

}  // namespace

uint32_t wholeTicks(double seconds, const Params& params) {
  constexpr double kMax = 0xffffffff;
  return uint32_t(std::clamp(std::floor(seconds * params.controlRate + 0.5), 0.0, kMax));
}

uint32_t Track::tickAt(double time, const Params& params) const {
  return wholeTicks(phase + time, params);
}

void Track::drop(size_t frame) {
  frames.erase(frames.begin() + std::ptrdiff_t(frame));
  const auto first = poses.begin() + std::ptrdiff_t(frame * shown.size());
  poses.erase(first, first + std::ptrdiff_t(shown.size()));
}

Result<Track> trackOf(schema::Recording::Reader record) {
  Track track{record.getName(), record.getLevel()};
  for (const auto part : record.getParts()) track.shown.emplace_back(part);
  const auto frames = record.getFrames();
  for (uint32_t i = 0; i < frames.size(); ++i) {
    Frame frame = frameOf(frames[i]);
    frame.time -= frames[0].getTime();  // some recorders use their own clock
    OBBY_RETURN_IF_ERROR(checkNumbers(frame, i));
    OBBY_RETURN_IF_ERROR(checkTime(frame, i, track));
    if (!track.frames.empty() && frame.time - track.frames.back().time < kApart) {
      OBBY_RETURN_IF_ERROR(addAgain(frame, frames[i], i, track));
      continue;
    }
    track.frames.push_back(frame);
    OBBY_RETURN_IF_ERROR(addPoses(frames[i], i, track));
  }
  if (track.frames.size() < 2)
    return Error{{},
                 {},
                 "frames",
                 fmt::format("expected at least 2 frames, found {}", track.frames.size()),
                 "leave out this recording"};
  return track;
}

}  // namespace obby::calibrate

#include "calibrate/track.h"

#include <fmt/format.h>

#include <cmath>

namespace obby::calibrate {

namespace {

constexpr float kLeastMove = 0.1f;
constexpr float kRising = 5;  // studs/s: faster than this upward is no walk

Vec3 vecOf(schema::Vec3::Reader v) { return {v.getX(), v.getY(), v.getZ()}; }

bool finite(Vec3 v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

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

Vec3 rootOf(Vec3 feet, const Params& p) {
  return feet + Vec3{0, p.hipHeight + 0.5f * p.rootHeight, 0};
}

Vec3 feetOf(const Frame& frame, const Params& p) {
  return frame.position - Vec3{0, p.hipHeight + 0.5f * p.rootHeight, 0};
}

sim::Action actionOf(const Frame& frame) {
  const bool walk =
      frame.move.x * frame.move.x + frame.move.z * frame.move.z > kLeastMove * kLeastMove;
  return {walk ? headingOf(frame.move.x, frame.move.z) : Turns(0), walk, frame.jump};
}

Result<Track> trackOf(schema::Recording::Reader record) {
  Track track{record.getName(), record.getLevel(), {}};
  const auto frames = record.getFrames();
  for (uint32_t i = 0; i < frames.size(); ++i) {
    const auto f = frames[i];
    const Frame frame{f.getTime(),
                      vecOf(f.getMove()),
                      f.getJump(),
                      vecOf(f.getPosition()),
                      vecOf(f.getVelocity()),
                      stateOf(f.getState(), vecOf(f.getVelocity()))};
    if (!std::isfinite(frame.time) || !finite(frame.move) || !finite(frame.position) ||
        !finite(frame.velocity))
      return inFrame(i, "a number that is none", "leave such frames out");
    if (!track.frames.empty() && frame.time < track.frames.back().time)
      return inFrame(i, fmt::format("time {} comes after {}", frame.time, track.frames.back().time),
                     "give the frames in the order of their times");
    if (!track.frames.empty() && frame.time == track.frames.back().time) continue;
    track.frames.push_back(frame);
  }
  if (track.frames.size() < 2)
    return Error{{},
                 {},
                 "frames",
                 fmt::format("{} of them", track.frames.size()),
                 "a recording needs two at least"};
  return track;
}

}  // namespace obby::calibrate

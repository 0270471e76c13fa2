// A body that rests, slides or turns steadily needs two samples. Only a bounce needs every tick.
#include "view/body_track.h"

#include <array>
#include <bit>
#include <utility>

#include "sim/rigid_body.h"
#include "view/thinning.h"

namespace obby::view {
namespace {

Quat mixed(Quat a, Quat b, float share) {
  const float sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -share : share;
  const float rest = 1 - share;
  return normalize(Quat{a.x * rest + b.x * sign, a.y * rest + b.y * sign, a.z * rest + b.z * sign,
                        a.w * rest + b.w * sign});
}

// Returns approximately the angle between two rotations, radians.
float turnBetween(Quat a, Quat b) {
  const float sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -1.0f : 1.0f;
  const float x = a.x - sign * b.x, y = a.y - sign * b.y, z = a.z - sign * b.z,
              w = a.w - sign * b.w;
  return 2 * std::sqrt(x * x + y * y + z * z + w * w);
}

struct Sample {
  Vec3 position;
  Quat rotation;
};

// Returns a sample for each of `count` ticks.
std::vector<Sample> samplesOf(const std::vector<BodyStay>& stays, const level::DynamicBody& l,
                              size_t count) {
  std::vector<Sample> out;
  out.reserve(count);
  for (size_t i = 0; i < stays.size(); ++i) {
    const BodyStay& stay = stays[i];
    const Pose pose = sim::partPose(l, stay.center, toMat3(stay.rotation));
    out.resize(i + 1 < stays.size() ? stays[i + 1].tick : count,
               Sample{pose.position, stay.rotation});
  }
  return out;
}

// Compares bits, so 0 and -0 differ.
bool isAt(const sim::RigidBody& b, const BodyStay& stay) {
  const auto bits = [](Vec3 p, Quat q) {
    return std::bit_cast<std::array<uint32_t, 7>>(std::array{p.x, p.y, p.z, q.x, q.y, q.z, q.w});
  };
  return bits(b.position, b.rotation) == bits(stay.center, stay.rotation);
}

// Returns the max distance between a point's positions in two poses, for points within `reach` of
// the part's centre.
float missBetween(const Sample& a, const Sample& b, float reach) {
  return length(a.position - b.position) + reach * turnBetween(a.rotation, b.rotation);
}

// Returns the max distance of missBetween() for sample `at` and the interpolation between `from`
// and `to`.
float missAt(const std::vector<Sample>& all, float reach, size_t from, size_t to, size_t at) {
  const float share = float(at - from) / float(to - from);
  const Sample &a = all[from], &b = all[to];
  return missBetween(
      all[at],
      {a.position + (b.position - a.position) * share, mixed(a.rotation, b.rotation, share)},
      reach);
}

}  // namespace

void BodyWatch::see(const sim::Moment& now) {
  for (size_t body = 0; body < stays_.size(); ++body) {
    const sim::RigidBody& b = now.bodies[body];
    std::vector<BodyStay>& stays = stays_[body];
    if (!stays.empty() && isAt(b, stays.back())) continue;
    stays.push_back({now.tick, b.position, b.rotation});
  }
  count_ = size_t(now.tick) + 1;
}

std::vector<BodyTrack> BodyWatch::tracks() const {
  std::vector<BodyTrack> out;
  if (count_ < 2) return out;
  for (uint32_t body = 0; body < level_.bodyCount; ++body) {
    const level::DynamicBody& l = level_.bodies[body];
    const std::vector<Sample> all = samplesOf(stays_[body], l, count_);
    const float reach = l.radius + length(l.center);
    BodyTrack track;
    track.part = level_.colliders[l.firstCollider].part;
    for (const size_t tick : thinned(all.size(), kBodyMiss, [&](size_t from, size_t to, size_t at) {
           return missAt(all, reach, from, to, at);
         })) {
      track.ticks.push_back(uint32_t(tick));
      track.add(all[tick].position, all[tick].rotation);
    }
    const bool straight = track.ticks.size() == 2;
    if (straight && missBetween(all.front(), all.back(), reach) <= kBodyMiss)
      continue;  // skips a body at rest
    out.push_back(std::move(track));
  }
  return out;
}

}  // namespace obby::view

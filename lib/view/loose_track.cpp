// A body that rests, slides or turns evenly needs two samples; a tick apart only where it bounces.
#include "view/loose_track.h"

#include "sim/loose.h"
#include "view/thinning.h"

namespace obby::view {
namespace {

Quat mixed(Quat a, Quat b, float share) {
  const float sign = a.x * b.x + a.y * b.y + a.z * b.z + a.w * b.w < 0 ? -share : share;
  const float rest = 1 - share;
  return normalize(Quat{a.x * rest + b.x * sign, a.y * rest + b.y * sign, a.z * rest + b.z * sign,
                        a.w * rest + b.w * sign});
}

// About the angle between two turns, radians.
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

std::vector<Sample> samplesOf(const sim::Replay& replay, const level::Loose& l, size_t body) {
  std::vector<Sample> out;
  out.reserve(replay.worlds.size());
  for (size_t tick = 0; tick < replay.worlds.size(); ++tick) {
    const sim::LooseBody& b = replay.looseAt(tick)[body];
    out.push_back({sim::poseOf(b, l).position, b.rotation});
  }
  return out;
}

// How far apart a point of the part is in two poses, at most, if none is farther than `reach` from
// the part's centre.
float missBetween(const Sample& a, const Sample& b, float reach) {
  return length(a.position - b.position) + reach * turnBetween(a.rotation, b.rotation);
}

// The same of a sample and where the part would be then on the way between two others.
float missAt(const std::vector<Sample>& all, float reach, size_t from, size_t to, size_t at) {
  const float share = float(at - from) / float(to - from);
  const Sample &a = all[from], &b = all[to];
  return missBetween(
      all[at],
      {a.position + (b.position - a.position) * share, mixed(a.rotation, b.rotation, share)},
      reach);
}

}  // namespace

std::vector<LooseTrack> looseTracksOf(const sim::Replay& replay, const level::LevelView& level) {
  std::vector<LooseTrack> tracks;
  if (replay.worlds.size() < 2) return tracks;
  for (uint32_t body = 0; body < level.looseCount; ++body) {
    const level::Loose& l = level.loose[body];
    const std::vector<Sample> all = samplesOf(replay, l, body);
    const float reach = l.radius + length(l.center);
    LooseTrack track;
    track.part = level.colliders[l.firstCollider].part;
    for (const size_t tick : thinned(
             all.size(), kLooseMiss,
             [&](size_t from, size_t to, size_t at) { return missAt(all, reach, from, to, at); })) {
      track.ticks.push_back(uint32_t(tick));
      track.add(all[tick].position, all[tick].rotation);
    }
    const bool straight = track.ticks.size() == 2;
    if (straight && missBetween(all.front(), all.back(), reach) <= kLooseMiss) continue;  // rests
    tracks.push_back(std::move(track));
  }
  return tracks;
}

}  // namespace obby::view

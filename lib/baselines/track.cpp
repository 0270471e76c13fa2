#include "baselines/track.h"

#include <algorithm>

#include "solve/search/archive/cell.h"

namespace obby::baselines {

namespace {

constexpr float kUnit = 0.25f;  // per stud

void write(Vec3 v, float* to) {
  to[0] = v.x * kUnit;
  to[1] = v.y * kUnit;
  to[2] = v.z * kUnit;
}

// Returns a hash of the reached waypoints and visits; 0 for none. Two different sets collide with a
// probability of 1 / kCodes.
uint32_t codeOf(const sim::World& world) {
  static_assert(kCodes == 1u << 16);
  return uint32_t(mixBits(uint64_t(world.waypoints) << 32 | world.visited) >> 48);
}

}  // namespace

void placeOf(const Problem& problem, const sim::World& world, const sim::LooseBody* loose,
             float* place) {
  write(world.position - problem.start.position, place);
  Vec3 moved;
  const uint32_t bodies = problem.level.looseCount;
  for (uint32_t i = 0; i < bodies; ++i) {
    if (loose[i].state == sim::LooseState::gone) continue;
    moved += loose[i].position - problem.startLoose[i].position;
  }
  write(moved * (bodies == 0 ? 0.0f : 1 / float(bodies)), place + 3);
  place[kReached] = float(targetsReached(world));
  place[kCode] = float(codeOf(world)) / float(kCodes);
}

void Memory::add(std::shared_ptr<const Track> track) {
  if (track->decisions() == 0) return;
  const size_t count = track->decisions();
  tracks_.push_back({end_, std::move(track)});
  end_ += count;
  while (tracks_.size() > 1 && size() > room_) tracks_.pop_front();
}

Memory::Place Memory::at(size_t i) const {
  const uint64_t at = tracks_.front().first + i;
  const auto after = std::upper_bound(tracks_.begin(), tracks_.end(), at,
                                      [](uint64_t a, const Kept& k) { return a < k.first; });
  const Kept& kept = *std::prev(after);
  return {kept.track.get(), size_t(at - kept.first)};
}

}  // namespace obby::baselines

#include "solve/proof/put_out.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "solve/proof/body_reach.h"
#include "solve/proof/coyote_drop.h"
#include "solve/proof/flight.h"
#include "solve/proof/solids.h"
#include "solve/proof/supports.h"

namespace obby::solve {

namespace {

constexpr float kUnbounded = std::numeric_limits<float>::infinity();
constexpr PutOut kUnknown{0, kUnbounded, 1};
constexpr float kFar = 1e6f;                    // studs: farther than levels reach
constexpr size_t kMostPutOutWork = 20'000'000;  // boxes looked at

class Finder {
 public:
  Finder(const level::LevelView& level, const Moves& moves)
      : level_(level),
        p_(level.params),
        moves_(moves),
        jump_(slowestJump(level)),
        fastest_(fastestJump(level)),
        side_(bodySide(p_) + kSlack),
        soon_(2 * side_ + 2 * p_.tickSeconds * moves.speed),
        late_(2 * side_ + (p_.coyoteTime + 3 * p_.tickSeconds) * moves.speed),
        solids_(level, {}),
        drop_(p_, p_.maxFallSpeed) {
    const uint32_t any = flagsOfAll(level);
    // Movers, belts and pads slow a jump down, trusses end it.
    calm_ = !(any & (level::kMoving | level::kConveyor | level::kPad | level::kTruss));
    const bool climbs = (any & level::kTruss) != 0;
    const int landed = landedTicksOf(p_);
    shortest_ = float(climbs ? 2 : landed + 2) * p_.tickSeconds;
    usual_ = jump_ / p_.gravity + float(landed + 1) * p_.tickSeconds;
    if (!calm_) usual_ = std::min(usual_, shortest_);
  }

  // All that somebody may jump from. Then look() at each.
  void know(const std::vector<Footing>& floors) {
    hips_.assign(level_.colliderCount, Hips{kFar, kFar, kFar});
    for (const Footing& f : floors) {
      hips_[f.collider] = lowestHips(f.collider);
      lowest_ = std::min(lowest_, solids_.box(f.collider).lo.y);
    }
  }

  void look(const Footing& from) {
    if (isTooMuch()) return;
    const Hips hips = hips_[from.collider];
    const Box floor = solids_.box(from.collider);
    const float later = std::max(hips.later, lowestStart(floor)), felt = std::min(hips.felt, later);
    const float lowest = std::min(felt, hips.lost);
    forSolids(beside(floor, late_, lowest, from.highest), [&](uint32_t id) {
      const Box& part = solids_.box(id);
      if (solids_.lowestTop(id) > from.highest) return;
      const float gap = gapBetween(floor, part);
      const float studs = std::max(gap <= soon_ ? depth(id, felt) : 0.0f,
                                   gap <= late_ ? lostDepth(id, hips.lost) : 0.0f);
      if (studs > 0) note(from.collider, id, studs, lowest);
    });
  }

  std::vector<PutOut> take() {
    if (isTooMuch()) return {kUnknown};
    return std::move(found_);
  }

 private:
  // Heights that the hips are above when a jump lets the torso collide again, for lack of a floor
  // that is felt.
  struct Hips {
    float felt;   // jumped from this floor
    float lost;   // likewise, in coyote time: after a tick
    float later;  // jumped from anywhere, and this floor was felt since then, the last of all
  };

  bool isTooMuch() const { return work_ > kMostPutOutWork; }

  template <class Found>
  void forSolids(const Box& where, Found&& found) {
    work_ += solids_.find(where, found);
  }

  // Who pushes through it comes out on its far side, wherever they came from.
  bool isThin(uint32_t id) const {
    const Vec3 half = level_.colliders[id].shape.half;
    const float least = std::min(half.x, half.z);
    return 2 * (solids_.isStill(id) ? least : std::min(least, half.y)) < bodyAcross(p_);
  }

  Hips lowestHips(uint32_t floor) {
    const uint32_t flags = level_.bounds[floor].flags;
    if (flags & (level::kMoving | level::kTruss | level::kConveyor)) return {-kFar, -kFar, -kFar};
    const Box box = solids_.box(floor);
    const float top = solids_.lowestTop(floor);
    const float felt = top - deepestFeet(p_);
    const float fallen = std::max(moves_.apex - felt, 0.0f);
    const float lost = std::min(felt, top - drop_.at(sqrtf32(2 * p_.gravity * fallen)));
    // A tick of the jump, if nothing stops it.
    const float dt = p_.tickSeconds, pull = p_.gravity * dt * dt;
    const bool rises = calm_ && !isStopped(box, floor, late_, lost);
    const float rise = rises ? jump_ * dt - 0.5f * pull : -pull;
    return {felt + rise + p_.hipHeight, lost + rise + p_.hipHeight, felt - pull + p_.hipHeight};
  }

  // The hips after the first tick of any jump on whose way the floor may be felt.
  float lowestStart(const Box& floor) {
    const float side = late_ + fastest_ / p_.gravity * moves_.speed;
    float lowest = kFar;
    forSolids(beside(floor, side, lowest_, floor.hi.y + p_.bodyTop),
              [&](uint32_t id) { lowest = std::min(lowest, hips_[id].lost); });
    return lowest;
  }

  bool isStopped(const Box& floor, uint32_t but, float side, float feet) {
    return solids_.stopsHead(floor, but, side, feet, moves_.apex + p_.bodyTop, work_);
  }

  // How far the torso can be in it, whose hips are at `hips` or higher.
  float depth(uint32_t id, float hips) const {
    return std::min(solids_.box(id).hi.y - hips, p_.headBottom - p_.hipHeight);
  }
  float lostDepth(uint32_t id, float hips) const {
    return std::min(depth(id, hips), moves_.speed * p_.tickSeconds);
  }

  // `part` puts out by so much who jumps from `floor`.
  void note(uint32_t floor, uint32_t part, float studs, float hips) {
    if (isTooMuch()) return;
    const Box box = solids_.box(part);
    forSolids(beside(box, bodyAcross(p_), hips, moves_.apex + p_.bodyTop), [&](uint32_t id) {
      if (id == part) return;
      const float more = depth(id, hips);
      if (more > 0) studs += isThin(id) ? kUnbounded : more;
    });
    // The skin, and what the body moves by until it is put out.
    studs += p_.contactSkin + moves_.speed * p_.substepSeconds;
    const Box start{moves_.start, moves_.start};
    const float away = std::max(gapBetween(start, box) - side_, 0.0f);
    found_.push_back({away, studs, secondsAfter(floor, part, hips)});
  }

  // What stops the jump later on does so when the head has passed over `part`.
  float secondsAfter(uint32_t floor, uint32_t part, float hips) {
    const float feet =
        std::max(hips - p_.hipHeight, solids_.box(part).hi.y - p_.headBottom - kSlack);
    const float side = late_ + jump_ / p_.gravity * moves_.speed;
    const bool stopped = usual_ > shortest_ && isStopped(solids_.box(floor), part, side, feet);
    return stopped ? shortest_ : usual_;
  }

  const level::LevelView& level_;
  const Params& p_;
  const Moves& moves_;
  const float jump_, fastest_;  // of jumps, studs/s: at least, at most
  const float side_;            // from the feet to what the body touches
  const float soon_, late_;     // studs from a floor to what is met from there, felt or lost
  std::vector<Hips> hips_;      // (colliders): of those that somebody may jump from
  const Solids solids_;
  const CoyoteDrop drop_;
  bool calm_ = false;
  float lowest_ = kFar;  // of what somebody may jump from
  float usual_ = 0;      // seconds from one jump to the next, at least
  float shortest_ = 0;   // likewise, where something may stop the jump
  size_t work_ = 0;
  std::vector<PutOut> found_;
};

}  // namespace

std::vector<PutOut> putOutsOf(const level::LevelView& level, const std::vector<Footing>& floors,
                              const Moves& moves) {
  // The legs of who falls down collide all of a sudden.
  if (anyHelpless(level)) return {kUnknown};
  if (floors.empty()) return {};
  Finder finder(level, moves);
  finder.know(floors);
  for (const Footing& floor : floors) finder.look(floor);
  return finder.take();
}

float secondsFor(float studs, float speed, std::vector<PutOut> outs, int32_t mostJumps) {
  std::sort(outs.begin(), outs.end(),
            [](const PutOut& a, const PutOut& b) { return a.away < b.away; });
  float farthest = 0;
  for (const PutOut& out : outs) {
    if (out.away < studs) farthest = std::max(farthest, out.studs);
  }
  if (std::isinf(farthest)) return 0;
  // Each but the last is as if somebody were faster until the next.
  const float left = studs - farthest;
  float seconds = 0, come = 0, more = 0;
  for (const PutOut& out : outs) {
    if (!(out.away < left)) break;
    seconds += (out.away - come) / (speed + more);
    come = out.away;
    more = std::max(more, out.studs / out.seconds);
  }
  seconds += std::max(left - come, 0.0f) / (speed + more);
  if (mostJumps < 0) return seconds;
  return std::max(seconds, (studs - farthest * float(mostJumps)) / speed);
}

}  // namespace obby::solve

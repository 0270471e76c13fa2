#include "solve/proof/pass_through.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/flight.h"
#include "solve/proof/supports.h"

namespace obby::solve {

namespace {

constexpr size_t kMostPassThroughWork = 20'000'000;  // boxes looked at

// Do keys alone make players fast, and nothing but gravity slow?
bool isCalm(const level::LevelView& level) {
  if (flagsOfAll(level) & (level::kMoving | level::kConveyor | level::kPad)) return false;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    if (isSolid(level, id) && !isUpright(level, id)) return false;
  }
  return true;
}

// How somebody comes to be in a low part. All in studs.
struct Ways {
  bool byJump, byFall, byClimb;  // a jump begins; somebody falls down; climbs very fast
  bool near;                     // jumps are felt near their floors, but things press down on them
  float thin;                    // what is thinner may be come through
  float side;                    // from such a floor to the low part, at most
  float least, most;             // from the top of a floor that is felt meanwhile to the part's
  float risen;                   // more than `least`: in a first tick that nothing overhead stops
  float travel, height;          // of a jump until it falls
  float broad;                   // nobody is put out of what is broader on its far side
};

Ways waysOf(const level::LevelView& level, bool mayJump) {
  const Params& p = level.params;
  const float narrow = std::min(p.bodyWidth, p.bodyDepth);
  const bool calm = isCalm(level);
  const float speed = calm ? fastestWalk(level) + keyOvershoot(p) : 1.42f * level.maxSideSpeed;
  const float upward = calm ? fastestJump(level) : p.maxFallSpeed;
  Ways w{};
  w.byJump = mayJump;
  w.byFall = anyHelpless(level);
  w.byClimb = (flagsOfAll(level) & level::kTruss) != 0 && 2 * speed * p.substepSeconds >= narrow;
  // Legs collide too as somebody falls down.
  const float deepest = p.headBottom - (w.byFall ? 0.0f : p.hipHeight) + 2 * p.contactSkin;
  w.thin = std::max(bodyAcross(p), 2 * deepest - narrow);
  // Without a floor a jump has the torso back after a tick.
  const bool lost = 2 * speed * (p.tickSeconds + p.substepSeconds) >= narrow;
  const float late = lost ? p.coyoteTime + 3 * p.tickSeconds : 2 * p.tickSeconds;
  w.near = !calm && !lost;
  w.side = 2 * (bodySide(p) + kSlack) + late * speed;
  w.most = p.headBottom + takeOffReach(p) + upward * p.tickSeconds + kSlack;
  const float sunk = deepestFeet(p) + (calm ? 0.0f : upward * p.tickSeconds);
  const float fallen = lost ? p.maxFallSpeed * late : 0.0f;
  w.least = p.hipHeight + 0.5f * narrow - sunk - fallen - kSlack;
  const float pull = 0.5f * p.gravity * p.tickSeconds * p.tickSeconds;
  w.risen = calm && !lost ? std::max(slowestJump(level) * p.tickSeconds - pull, 0.0f) : 0.0f;
  const float jump = fastestJump(level), gravity = std::max(p.gravity, 1.0f);
  w.travel = jump / gravity * speed;
  w.height = 0.5f * jump * jump / gravity;
  w.broad = deepest + w.travel + late * speed;
  return w;
}

// Upright blocks from side to side: who comes through one upward or down is beside it still.
bool isThin(const level::LevelView& level, uint32_t id, const Ways& ways) {
  const Vec3 half = level.colliders[id].shape.half;
  const float side = std::min(half.x, half.z);
  return isSolid(level, id) &&
         2 * (isUpright(level, id) ? side : std::min(side, half.y)) < ways.thin;
}

class Passer {
 public:
  Passer(const level::LevelView& level, const Solids& solids, bool mayJump)
      : level_(level),
        solids_(solids),
        ways_(waysOf(level, mayJump)),
        entered_(level.colliderCount, Entered::unknown),
        known_(level.colliderCount, false),
        where_(level.colliderCount) {}

  void find() {
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (isThin(level_, id, ways_) && work_ <= kMostPassThroughWork) beginAt(id);
    }
    while (!open_.empty() && work_ <= kMostPassThroughWork) {
      const uint32_t part = open_.back();
      open_.pop_back();
      leadOn(part);
    }
    if (work_ > kMostPassThroughWork) takeAll();
  }

  // They touch the part as it puts them out.
  void note(Pressing& found) const {
    const float side = bodySide(level_.params) + kSlack;
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (!known_[id]) continue;
      const Box feet = grow(solids_.box(id), {side, level_.params.bodyTop + kSlack, side});
      found.noteAround(id, kAtOnce, common(where_[id], feet));
    }
  }

 private:
  enum class Entered : uint8_t { unknown, no, yes };

  void beginAt(uint32_t wall) {
    work_ += solids_.find(solids_.touching(wall), [&](uint32_t low) {
      if (low == wall || !isBehind(wall, low) || isOnBroad(wall, low)) return;
      const Box out = solids_.touching(low);
      if (solids_.standOnEachOther(wall, low, solids_.putOut(wall, out))) return;
      if (isComeInto(low, wall)) pass(wall, out);
    });
  }

  // Is it too tall to be stepped onto from the low one, and where the torso of somebody in that is?
  bool isBehind(uint32_t wall, uint32_t low) const {
    const Params& p = level_.params;
    const Box &tall = solids_.box(wall), &box = solids_.box(low);
    return tall.hi.y > box.hi.y + p.hipHeight && tall.lo.y < box.hi.y + p.bodyTop - p.hipHeight;
  }

  // Does it stand on what is so broad that who jumps into that comes out before it, or over it?
  bool isOnBroad(uint32_t wall, uint32_t low) const {
    if (ways_.byFall || ways_.byClimb || !solids_.isStill(low)) return false;
    const level::Collider& c = level_.colliders[low];
    const Vec3 x = c.pose.rotation.x;
    const bool aligned = std::max(absf(x.x), absf(x.z)) > 0.9999f;  // its bounds are its rims
    if (!aligned || 2 * std::min(c.shape.half.x, c.shape.half.z) < ways_.broad) return false;
    const Box &above = solids_.box(wall), &below = solids_.box(low);
    const bool within = above.lo.x >= below.lo.x && above.hi.x <= below.hi.x &&
                        above.lo.z >= below.lo.z && above.hi.z <= below.hi.z;
    return within && above.lo.y >= below.hi.y - kSlack;
  }

  bool isComeInto(uint32_t low, uint32_t wall) {
    if (ways_.byFall) return true;
    if (ways_.byClimb && (level_.bounds[low].flags & level::kTruss) != 0) return true;
    if (!ways_.byJump) return false;
    // Nobody jumps off the wall to be beside it at once.
    if (ways_.near) return isJumpedInto(low, wall);
    Entered& known = entered_[low];
    if (known == Entered::unknown) {
      known = isJumpedInto(low, level::kNone) ? Entered::yes : Entered::no;
    }
    return known == Entered::yes;
  }

  bool isJumpedInto(uint32_t low, uint32_t wall) {
    const Box& box = solids_.box(low);
    const float lowest = solids_.lowestTop(low) - ways_.most;
    const float highest = box.hi.y - ways_.least, begun = highest - ways_.risen;
    const auto isFloor = [&](float side, float from, float to) {
      return isAnyTop(beside(box, side, from, to), low, wall);
    };
    if (isFloor(ways_.side, lowest, begun)) return true;
    // Or a jump from farther down feels a floor that is too high for one from there.
    if (!isFloor(ways_.side, lowest, highest)) return false;
    return isStopped(low, begun) ||
           isFloor(ways_.side + ways_.travel, lowest - ways_.height, begun);
  }

  // Is the top of a part there, but of these two?
  bool isAnyTop(const Box& where, uint32_t low, uint32_t wall) {
    bool found = false;
    work_ += solids_.find(where, [&](uint32_t id) {
      const bool within = solids_.lowestTop(id) <= where.hi.y && solids_.box(id).hi.y >= where.lo.y;
      found |= id != low && id != wall && within;
    });
    return found;
  }

  // Is another part near where it can stop the head of who jumps off a floor of that height?
  bool isStopped(uint32_t low, float floor) {
    const Params& p = level_.params;
    const float highest = solids_.box(low).hi.y + ways_.most + p.bodyTop;
    return solids_.stopsHead(solids_.box(low), low, ways_.side, floor - deepestFeet(p), highest,
                             work_);
  }

  // Somebody within `from` may be put out of the part.
  void pass(uint32_t part, const Box& from) {
    const Box out = solids_.putOut(part, from);
    if (known_[part] && isWithin(out, where_[part])) return;
    where_[part] = known_[part] ? join(where_[part], out) : out;
    known_[part] = true;
    if (isThin(level_, part, ways_)) open_.push_back(part);
  }

  // From what is thick they come back.
  void leadOn(uint32_t part) {
    const Box where = where_[part];
    work_ += solids_.find(where, [&](uint32_t next) {
      if (next != part && !solids_.standOnEachOther(part, next, where)) pass(next, where);
    });
  }

  // Too much to look at: all that is thin may be come through.
  void takeAll() {
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (!isThin(level_, id, ways_)) continue;
      known_[id] = true;
      where_[id] = solids_.touching(id);
    }
  }

  const level::LevelView& level_;
  const Solids& solids_;
  const Ways ways_;
  std::vector<Entered> entered_;  // (colliders): by a jump
  std::vector<bool> known_;       // (colliders): may somebody be put out of it?
  std::vector<Box> where_;        // (colliders): all of the body of those
  std::vector<uint32_t> open_;    // thin ones, to be followed
  size_t work_ = 0;
};

}  // namespace

bool mayPassThrough(const level::LevelView& level, bool mayJump) {
  const Ways ways = waysOf(level, mayJump);
  if (!ways.byJump && !ways.byFall && !ways.byClimb) return false;
  for (uint32_t id = 0; id < level.colliderCount; ++id) {
    if (isThin(level, id, ways)) return true;
  }
  return false;
}

void passThrough(const level::LevelView& level, const Solids& solids, bool mayJump,
                 Pressing& found) {
  Passer passer(level, solids, mayJump);
  passer.find();
  passer.note(found);
}

}  // namespace obby::solve

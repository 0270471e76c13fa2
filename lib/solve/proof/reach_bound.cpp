#include "solve/proof/reach_bound.h"

#include <algorithm>
#include <array>
#include <map>

#include "sim/candidates.h"

namespace obby::solve {

namespace {

constexpr size_t kMaxVisits = 60;  // per support, on average; beyond this the bound gives up
constexpr int kMaxParts = 8;       // max counted parts near a flight; turns limit the push of more

constexpr float kRounding = 0.125f;  // studs
constexpr int32_t kMaxBlocks = 8;  // max blocks per axis; the crowded places of a block share a box

// Returns true if the list of a cell has more parts than a tick examines. The list has all parts
// that a player in the cell can be near, at any speed.
bool isCrowded(const level::LevelView& level, const uint32_t* list) {
  const auto moves = [&](uint32_t id) { return (level.bounds[id].flags & level::kMoving) != 0; };
  const int moving = int(std::count_if(list + 1, list + 1 + list[0], moves));
  return list[0] > uint32_t(sim::kMaxCandidates) || moving > sim::kMaxMovingCandidates;
}

// Returns the places of the feet that have more parts near than a tick examines. The simulator
// ignores the others for that tick, so nothing is known about what follows.
std::vector<Box> crowdedPlaces(const level::LevelView& level) {
  const level::Grid& g = level.grid;
  const Vec3 size{1 / g.inverseCell.x, 1 / g.inverseCell.y, 1 / g.inverseCell.z};
  const int32_t block = std::max({g.nx, g.ny, g.nz}) / kMaxBlocks + 1;  // cells
  std::map<std::array<int32_t, 3>, Box> blocks;
  std::vector<int8_t> known(g.listWords, -1);  // (starts of lists): -1 unknown, 0 no, 1 yes
  for (int32_t i = 0; i < g.nx * g.ny * g.nz; ++i) {
    const uint32_t at = g.cells[i];
    if (known[at] < 0) known[at] = isCrowded(level, g.lists + at) ? 1 : 0;
    if (known[at] == 0) continue;
    const int32_t x = i % g.nx, y = i / g.nx % g.ny, z = i / g.nx / g.ny;
    const Vec3 lo = g.origin + mul(size, Vec3{float(x), float(y), float(z)});
    const Box cell = grow(Box{lo, lo + size}, {kRounding, kRounding, kRounding});
    Box& joined = blocks.try_emplace({x / block, y / block, z / block}, cell).first->second;
    joined = join(joined, cell);
  }
  std::vector<Box> places;
  for (const auto& entry : blocks) places.push_back(entry.second);
  return places;
}

std::vector<Box> flatBoxes(const std::vector<Support>& supports) {
  std::vector<Box> boxes;
  boxes.reserve(supports.size());
  for (const Support& s : supports) boxes.push_back(flat(s.box, s.side));
  return boxes;
}

}  // namespace

ReachBound::ReachBound(const Problem& problem, bool mayJump)
    : problem_(problem),
      p_(problem.level.params),
      motions_(partMotions(problem.level)),
      limits_(problem, motions_),
      mayJump_(mayJump),
      supports_(supportsOf(problem, limits_, motions_)),
      index_(flatBoxes(supports_)),
      jumps_(supports_.size(), kNever),
      isOpen_(supports_.size()) {
  for (const Support& s : supports_) {
    lowest_ = std::min(lowest_, s.entry);
    if (s.beside != Beside::deep) pushed_ = std::max(pushed_, s.pushes);
    tossed_ = std::max({tossed_, s.toss, mayLeap(s) ? limits_.jump + s.upward : 0});
  }
  explore();
  for (const Box& place : crowdedPlaces(problem.level)) {
    wild_ = wild_ || jumpsInto({place, place.lo.y}) != kNever;
  }
}

// Reached supports let players take off higher and faster, so that more supports are reached.
void ReachBound::explore() {
  come(0, 0);
  for (size_t visits = 0; !open_.empty() && !wild_; ++visits) {
    const uint32_t at = open_.front();
    const Support& s = supports_[at];
    open_.pop_front();
    isOpen_[at] = false;
    wild_ = s.wild || visits > kMaxVisits * supports_.size();
    for (uint32_t i = 0; i < supports_.size() && s.sideways > excess_; ++i) {
      if (isReached(i)) leave(i);
    }
    excess_ = std::max(excess_, s.sideways);
    if (s.leadsTo != level::kNone) come(s.leadsTo, jumps_[at]);
    spread(at, false);
    if (mayLeap(s)) spread(at, true);
  }
}

void ReachBound::come(uint32_t support, uint32_t jumps) {
  if (jumps >= jumps_[support]) return;
  jumps_[support] = jumps;
  leave(support);
}

void ReachBound::leave(uint32_t support) {
  if (!isOpen_[support]) open_.push_back(support);
  isOpen_[support] = true;
}

void ReachBound::spread(uint32_t from, bool leaps) {
  const Flight f = flight(from, leaps);
  const uint32_t jumps = jumpsAfter(from, f);
  const float max = std::max(reach(f, lowest_ - limits_.entryOfFalls(), kMaxParts),
                             limits_.sideways(limits_.late, excess_));
  index_.any(flat(supports_[from].box, max + supports_[from].side), [&](uint32_t to) {
    const float takeOff = takeOffAfter(from, to, f);
    const bool higher = takeOff > supports_[to].takeOff + 1e-4f;
    if ((jumps >= jumps_[to] && !higher) || !crosses(from, f, endAt(to))) return false;
    if (higher) {
      supports_[to].takeOff = takeOff;
      leave(to);
    }
    come(to, jumps);
    return false;
  });
}

// Returns the max height above the top of the support `to` from which it can be left after the
// flight `f`.
float ReachBound::takeOffAfter(uint32_t from, uint32_t to, const Flight& f) const {
  const Support &a = supports_[from], &b = supports_[to];
  const float floor = b.top() + b.lift, high = limits_.apex(f) - floor;
  if (!b.carries || high <= b.takeOff) return 0;
  // The flight may also begin lower and be slower. A moving floor can follow the jumps off it.
  const float gain = from == to ? a.vertical : 0;
  float low = from == to ? a.top() - gain * (p_.coyoteTime + p_.tickSeconds) : a.lowest;
  if (f.leaps) low += limits_.lowApex(limits_.slowJump - 3 * gain, true);
  return limits_.takeOff(low - limits_.sunk - floor, high);
}

Flight ReachBound::flight(uint32_t support, bool leaps) const {
  const Support& s = supports_[support];
  float up = s.toss, height = s.top() + s.lift + s.takeOff;
  if (leaps) {
    up = limits_.jump + s.upward;
    height += limits_.apex(s.rising, false) + limits_.heldRise;
  } else if (s.beside == Beside::deep) {  // a body leaves it at any speed that a support may give
    up = std::max(up, tossed_);
    height += limits_.heldRise;
  } else if (s.beside == Beside::pinched && mayJump_) {
    up = std::max(up, limits_.jump);
  }
  // The first tick of a launch is not limited to the max speed, and a tick of a trick may end
  // higher.
  if (up > p_.maxFallSpeed || (p_.tricks & (kHeldJump | kLegThrow))) height += up * p_.tickSeconds;
  return {height, std::min(up, p_.maxFallSpeed), leaps, leaps ? s.stand : s.side};
}

// Returns true if the flight may begin inside `to`. The torso does not collide as a jump begins, so
// it may be inside a part that the head clears.
bool ReachBound::stepsInto(const Flight& f, const End& to, float distance) const {
  if (!f.leaps || to.support == kNever || !supports_[to.support].carries) return false;
  const float head = f.height + f.up * (p_.tickSeconds + p_.substepSeconds) + p_.headBottom;
  return supports_[to.support].lowest <= head + limits_.slack &&
         distance <= limits_.sideways(limits_.late, excess_);
}

// Returns the studs that a flight covers until the feet are at `height`; negative if they never
// are. Parts on the way lift a body that turns next to them, or push it on.
float ReachBound::reach(const Flight& f, float height, int parts) const {
  const float seconds = limits_.seconds(f, height - float(parts) * limits_.turned);
  const float studs = limits_.sideways(seconds, excess_);
  if (parts == 0 || studs < 0) return studs;
  const float each = 2 * limits_.turned, turns = limits_.turning * seconds + each;
  const bool all = parts == kMaxParts;
  return studs + pushed_ * seconds + (all ? turns : std::min(float(parts) * each, turns));
}

bool ReachBound::crosses(uint32_t from, const Flight& f, const End& to) const {
  const float distance = gapBetween(supports_[from].box, to.box) - to.side;
  if (stepsInto(f, to, distance - supports_[from].side)) return true;
  const float height = to.height - (f.leaps ? 0 : limits_.entryOfFalls());
  const float own = std::max(distance - f.radius, 0.0f);
  if (reach(f, height, 0) >= own) return true;
  for (int parts = kMaxParts;;) {  // lowers the count to the parts in reach, until it is stable
    const float studs = reach(f, height, parts);
    if (studs < own) return false;
    const int near = partsNear(from, f, to, studs);
    if (near >= parts) return true;
    parts = near;
  }
}

// Returns the number of solid parts that a flight of `studs` studs may meet, up to kMaxParts.
int ReachBound::partsNear(uint32_t from, const Flight& f, const End& to, float studs) const {
  const Support& s = supports_[from];
  const float low = to.height - limits_.entryOfFalls(), high = limits_.apex(f) + p_.bodyTop;
  const float far = studs + f.radius + to.side + 2 * limits_.body;
  int count = 0;
  index_.any(flat(join(s.box, to.box), far), [&](uint32_t i) {
    const Support& by = supports_[i];
    const bool meets = i != from && i != to.support && by.carries && by.box.hi.y >= low &&
                       by.box.lo.y <= high &&
                       gapBetween(s.box, by.box) + gapBetween(by.box, to.box) <= far;
    count += meets ? 1 : 0;
    return count == kMaxParts;
  });
  return count;
}

ReachBound::End ReachBound::endAt(uint32_t support) const {
  const Support& s = supports_[support];
  return {s.box, s.entry, s.side, support};
}

}  // namespace obby::solve

#include "solve/proof/supports.h"

#include <algorithm>

#include "sim/floor.h"
#include "solve/proof/contacts.h"

namespace obby::solve {

namespace {

constexpr uint32_t kLeads = level::kPad | level::kTeleport | level::kSeat;

class Builder {
 public:
  Builder(const Problem& problem, const BodyLimits& limits, const std::vector<PartMotion>& motions)
      : problem_(problem),
        level_(problem.level),
        p_(level_.params),
        limits_(limits),
        motions_(motions) {}

  std::vector<Support> build() {
    addPoint(problem_.start.position, problem_.start.velocity);
    std::vector<Vec3> appear{problem_.start.position};
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (!(level_.bounds[i].flags & level::kTeleport)) continue;
      appear.push_back(level_.roles[level_.colliders[i].role].teleportTo);
      addPoint(appear.back(), {});
    }
    const Contacts contacts(level_, limits_, motions_, appear);
    for (uint32_t i = 0, gate = 1; i < level_.colliderCount; ++i) {
      if (!isAny(i)) continue;
      supports_.push_back(supportOf(i, motions_[i], contacts));
      if (level_.bounds[i].flags & level::kTeleport) supports_.back().leadsTo = gate++;
    }
    for (Support& s : supports_) {
      if (s.level && s.carries) s.held = heldOver(s, contacts);
    }
    return std::move(supports_);
  }

 private:
  bool isAny(uint32_t id) const {
    const uint32_t flags = level_.bounds[id].flags;
    return (flags & (level::kSolid | kLeads)) != 0 || trips(id);
  }

  // Does a touch of it take the legs away?
  bool trips(uint32_t id) const {
    if (!(level_.bounds[id].flags & level::kStarts)) return false;
    const level::Roles& r = level_.roles[level_.colliders[id].role];
    return std::any_of(std::begin(r.starts), std::end(r.starts), [&](uint32_t clock) {
      return clock != level::kNone && level_.clocks[clock].helpless != 0;
    });
  }

  void addPoint(Vec3 feet, Vec3 velocity) {
    Support s;
    s.box = s.feet = {feet, feet};
    s.entry = s.entryFalling = 1e30f;
    s.top = feet.y;
    s.toss = std::max(velocity.y, 0.0f);
    s.sideways = length(Vec3{velocity.x, 0, velocity.z});
    supports_.push_back(s);
  }

  Support supportOf(uint32_t id, const PartMotion& motion, const Contacts& contacts) const {
    const level::Collider& c = level_.colliders[id];
    const uint32_t flags = level_.bounds[id].flags;
    Support s;
    s.collider = id;
    s.box = motion.swept;
    s.carries = (flags & level::kSolid) != 0;
    s.top = s.box.hi.y;
    s.beside = contacts.besideOf(id);
    s.pushes = s.carries ? motion.step * p_.controlRate : 0;
    s.level = s.carries && (flags & level::kUpright);
    // What is put back as its clock ends is nowhere at a known speed.
    s.vertical = (flags & level::kTriggered) ? 1e6f : std::max(motion.vertical, motion.upward);
    s.lowest = s.box.lo.y + (s.level ? 2 * c.shape.half.y : -p_.bodyTop);
    s.upward = motion.upward;
    s.sideways = motion.sideways;
    s.lift = limits_.settles + limits_.legsOvershoot(motion.vertical) + climb_ * p_.tickSeconds;
    s.side = s.carries ? limits_.body : 0;
    s.stand = limits_.stand;
    addRoles(s, c, flags);
    s.toss = std::max(s.toss, s.upward + (s.upward > 0 ? climb_ : 0));
    s.rising = std::max(s.upward, (flags & level::kTruss) != 0 ? s.upward + climb_ : 0.0f);
    // A slope turns a fall aside, and a walk upward.
    const bool slope = s.carries && !(flags & level::kUpright);
    s.wild = slope || trips(id) || (flags & level::kSeat) != 0;
    setEntry(s, flags, motion.step);
    s.feet = grow(s.box, {s.side, 0, s.side});
    s.feet.hi.y += s.lift;
    return s;
  }

  void addRoles(Support& s, const level::Collider& c, uint32_t flags) const {
    const level::Roles& r = level_.roles[c.role];
    if (flags & level::kConveyor) s.lift += limits_.legsOvershoot(s.upward);
    if (flags & level::kPad) {
      s.toss = std::max(s.toss, r.padVelocity.y);
      s.lift += limits_.slack + 1.5f * p_.touchMargin;
    }
    if (flags & level::kTruss) {
      s.climbed = true;
      s.stand = s.side = s.side + p_.climbReach + limits_.ray;
      s.lift += 2 * climb_ * p_.tickSeconds + limits_.slack;
      s.toss = std::max(s.toss, s.upward + climb_);
    }
    if (flags & kLeads) s.side = std::max(s.side, limits_.limb);
    if ((flags & level::kTeleport) && r.teleportKeepsVelocity) s.wild = true;
  }

  void setEntry(Support& s, uint32_t flags, float step) const {
    const float anywhere = s.box.lo.y - p_.bodyTop - 1.5f * p_.touchMargin - limits_.slack;
    const bool above = s.carries && s.beside != Beside::deep && (flags & level::kUpright) &&
                       !(flags & (kLeads | level::kTruss)) && !s.wild;
    s.entry = above ? limits_.entryLeaping(s.lowest, s.beside == Beside::pinched) - step : anywhere;
    s.entryFalling = above ? limits_.entryFalling(s.lowest) - step : anywhere;
  }

  // Where a ceiling stops a jump, or an edge holds the torso, a landing is slow.
  float heldOver(const Support& s, const Contacts& contacts) const {
    float most = 0;
    const float near = 2 * limits_.body + limits_.walk * 0.15f;
    const Box around = grow(s.box, {near, 1e6f, near});
    contacts.find(around, [&](uint32_t id) {
      if (id == s.collider) return;
      const Box& box = motions_[id].swept;
      const bool exact = contacts.besideOf(id) != Beside::deep && motions_[id].step == 0 &&
                         (level_.bounds[id].flags & level::kUpright) != 0;
      const float under = box.lo.y - p_.bodyTop - s.top;
      const Span heads = exact ? Span{under - limits_.slack, under + limits_.slack}
                               : Span{under, box.hi.y - s.top};
      const bool within = heads.hi > 0 && heads.lo < limits_.mostTakeOff() + 40;
      if (within) most = std::max(most, limits_.takeOff(heads, s.upward));
      const float resting = box.hi.y - p_.hipHeight - s.top;
      const float lowest = exact ? resting : box.lo.y - s.top - p_.bodyTop;
      if (resting > 0 && lowest < limits_.mostTakeOff()) {
        most = std::max(most, std::min(resting, limits_.mostTakeOff()));
      }
    });
    return most;
  }

  float climbOf() const {
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (level_.bounds[i].flags & level::kTruss) return p_.climbSpeed * fastestWalk(level_);
    }
    return 0;
  }

  const Problem& problem_;
  const level::LevelView& level_;
  const Params& p_;
  const BodyLimits& limits_;
  const std::vector<PartMotion>& motions_;
  const float climb_ = climbOf();
  std::vector<Support> supports_;
};

}  // namespace

std::vector<Support> supportsOf(const Problem& problem, const BodyLimits& limits,
                                const std::vector<PartMotion>& motions) {
  return Builder(problem, limits, motions).build();
}

std::vector<Support> supportsOf(const Problem& problem) {
  const std::vector<PartMotion> motions = motionsOf(problem);
  return supportsOf(problem, BodyLimits(problem, motions), motions);
}

}  // namespace obby::solve

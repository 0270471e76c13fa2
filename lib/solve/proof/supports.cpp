#include "solve/proof/supports.h"

#include <algorithm>

namespace obby::solve {

namespace {

constexpr uint32_t kLeads = level::kPad | level::kTeleport | level::kSeat;

class Builder {
 public:
  Builder(const Problem& problem, const BodyLimits& limits, const std::vector<PartMotion>& motions)
      : level_(problem.level),
        p_(level_.params),
        limits_(limits),
        motions_(motions),
        solids_(solidBoxes()),
        beside_(level_.colliderCount, Beside::clear),
        pressed_(level_.colliderCount, noBox()),
        grown_(level_.colliderCount) {
    addPoint(problem.start.position, problem.start.velocity);
    std::vector<Vec3> appear{problem.start.position};
    for (uint32_t i = 0; i < level_.colliderCount; ++i) {
      if (level_.bounds[i].flags & level::kTruss) climb_ = p_.climbSpeed * limits_.walk;
      if (!(level_.bounds[i].flags & level::kTeleport)) continue;
      appear.push_back(level_.roles[level_.colliders[i].role].teleportTo);
      addPoint(appear.back(), {});
    }
    findContacts(appear);
  }

  std::vector<Support> build() {
    for (uint32_t i = 0, gate = 1; i < level_.colliderCount; ++i) {
      const uint32_t flags = level_.bounds[i].flags;
      if (!(flags & (level::kSolid | kLeads)) && !trips(i)) continue;
      supports_.push_back(supportOf(i));
      if (flags & level::kTeleport) supports_.back().leadsTo = gate++;
    }
    return std::move(supports_);
  }

 private:
  std::vector<Box> solidBoxes() const {
    std::vector<Box> boxes;
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      const bool solid = (level_.bounds[id].flags & level::kSolid) != 0;
      boxes.push_back(solid ? motions_[id].swept : noBox());
    }
    return boxes;
  }

  // Finds out how a body may be next to each part (docs/proof.md, Contacts).
  void findContacts(const std::vector<Vec3>& appear) {
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (isRough(id)) press(id, motions_[id].swept);
    }
    for (const Vec3 feet : appear) {
      const float side = limits_.body;
      const Box torso{feet + Vec3{-side, p_.hipHeight + 2 * limits_.slack, -side},
                      feet + Vec3{side, p_.bodyTop, side}};
      solids_.any(torso, [&](uint32_t id) {
        press(id, motions_[id].swept);
        return false;
      });
    }
    for (bool grows = true; grows;) {
      grows = false;
      for (uint32_t id = 0; id < level_.colliderCount; ++id) {
        if (!grown_[id]) continue;
        grown_[id] = false;
        grows = true;
        pushOn(id);
      }
    }
    for (uint32_t id = 0; id < level_.colliderCount; ++id) {
      if (beside_[id] == Beside::clear && isPinched(id)) beside_[id] = Beside::pinched;
    }
  }

  // Returns true if a body can be inside the part without being pressed into it.
  bool isRough(uint32_t id) const {
    constexpr uint32_t kLeaps =
        level::kVanishTimer | level::kClocked | level::kOneWay | level::kTriggered;
    const uint32_t flags = level_.bounds[id].flags;
    if (!(flags & level::kSolid) || !(flags & (kLeaps | level::kMoving))) return false;
    if ((flags & kLeaps) || !(flags & level::kUpright)) return true;
    // A slow part that has no other part near pushes a body that nothing else holds. If it comes
    // down, it does not pass through the head, the only limb that collides as a jump begins.
    const PartMotion& m = motions_[id];
    const float upward =
        (limits_.jump + m.upward) * p_.substepSeconds + m.vertical * p_.tickSeconds;
    const bool slow = m.step < 0.25f * std::min(p_.bodyWidth, p_.bodyDepth) &&
                      upward < 0.45f * (p_.bodyTop - p_.headBottom);
    const float far = limits_.across + 2 * m.step;
    return !slow || solids_.any(grow(m.swept, {far, p_.bodyTop, far}),
                                [&](uint32_t other) { return other != id; });
  }

  // Returns half the smallest extent of the part's swept box, an upper bound on its half thickness.
  float thickness(uint32_t id) const {
    const Vec3 size = motions_[id].swept.hi - motions_[id].swept.lo;
    return 0.5f * std::min({size.x, size.y, size.z});
  }

  // Notes that a body may be inside the part in that place.
  void press(uint32_t id, const Box& where) {
    beside_[id] = Beside::deep;
    if (isWithin(where, pressed_[id])) return;
    pressed_[id] = join(pressed_[id], where);
    grown_[id] = true;
  }

  // Depenetration may move a body from a deep part into the next one. A part that is thicker than
  // the push pushes the body back. A thinner part may push it on, from where they meet.
  void pushOn(uint32_t id) {
    const float push = thickness(id) + motions_[id].step + limits_.body + 1;
    const float far = limits_.across + 2 * push;
    const Box region = grow(pressed_[id], {far, p_.bodyTop + 2 * push, far});
    solids_.any(region, [&](uint32_t other) {
      const Box& box = motions_[other].swept;
      beside_[other] = Beside::deep;
      if (thickness(other) <= push + limits_.body) {
        press(other, {max(box.lo, region.lo), min(box.hi, region.hi)});
      }
      return false;
    });
  }

  // Returns true if another part and this one may hold a body from opposite sides.
  bool isPinched(uint32_t id) const {
    if (!(level_.bounds[id].flags & level::kSolid)) return false;
    if (limits_.overlap >= limits_.turned) return true;
    const float torso = p_.bodyTop - p_.hipHeight + limits_.slack;
    const float fits = std::min(p_.bodyWidth, p_.bodyDepth) - 4 * limits_.slack - 0.1f;
    const Box& box = motions_[id].swept;
    const bool axial = isAxial(level_, id);
    return solids_.any(grow(box, {limits_.across, torso, limits_.across}), [&](uint32_t other) {
      const bool apart = gapBetween(box, motions_[other].swept) > fits;
      return other != id && (apart || !axial || !isAxial(level_, other));
    });
  }

  // Returns true if touching the part makes the player helpless.
  bool trips(uint32_t id) const {
    if (!(level_.bounds[id].flags & level::kStarts)) return false;
    const level::Roles& r = level_.roles[level_.colliders[id].role];
    return std::any_of(std::begin(r.starts), std::end(r.starts), [&](uint32_t clock) {
      return clock != level::kNone && level_.clocks[clock].helpless != 0;
    });
  }

  void addPoint(Vec3 feet, Vec3 velocity) {
    Support s;
    s.box = {feet, feet};
    s.lowest = feet.y;
    s.toss = std::max(velocity.y, 0.0f);
    s.sideways = length(Vec3{velocity.x, 0, velocity.z});
    supports_.push_back(s);
  }

  Support supportOf(uint32_t id) const {
    const level::Collider& c = level_.colliders[id];
    const level::Roles& r = level_.roles[c.role];
    const PartMotion& motion = motions_[id];
    const uint32_t flags = level_.bounds[id].flags;
    const bool upright = (flags & level::kUpright) != 0, truss = (flags & level::kTruss) != 0;
    Support s;
    s.collider = id;
    s.box = motion.swept;
    s.lowest = s.box.lo.y + (upright ? 2 * c.shape.half.y : -p_.bodyTop);
    s.carries = (flags & level::kSolid) != 0;
    s.beside = beside_[id];
    // A slope turns a fall sideways, and a walk upward.
    s.wild = (s.carries && !upright) || trips(id) || (flags & level::kSeat) ||
             ((flags & level::kTeleport) && r.teleportKeepsVelocity);
    s.sideways = motion.sideways;
    s.pushes = s.carries ? motion.step * p_.controlRate : 0;
    // A part that is put back when its clock ends has no known speed.
    s.vertical = (flags & level::kTriggered) ? 1e6f : std::max(motion.vertical, motion.upward);
    s.upward = motion.upward;
    s.rising = s.upward + (truss || s.upward > 0 ? climb_ : 0);
    s.toss = std::max(s.rising, s.carries ? limits_.thrown(s.vertical) + s.upward : 0);
    s.lift = limits_.settles + limits_.legsOvershoot(motion.vertical) + climb_ * p_.tickSeconds;
    if (flags & level::kConveyor) s.lift += limits_.legsOvershoot(s.upward);
    s.side = s.carries ? limits_.body : 0;
    s.stand = limits_.stand;
    if (truss) {
      s.stand = s.side = s.side + p_.climbReach + limits_.ray;
      s.lift += 2 * climb_ * p_.tickSeconds + limits_.slack;
      // A flick leaves the truss as fast as a jump.
      if (p_.tricks & kLadderFlick) s.toss = std::max(s.toss, limits_.jump + s.upward);
    }
    if (flags & level::kPad) {
      s.toss = std::max(s.toss, r.padVelocity.y);
      s.lift += limits_.slack + 1.5f * p_.touchMargin;
    }
    if (flags & kLeads) s.side = std::max(s.side, limits_.limb);
    const bool above =
        s.carries && s.beside != Beside::deep && !s.wild && !(flags & (kLeads | level::kTruss));
    s.entry = above ? limits_.entry(s.lowest, s.beside == Beside::pinched) - motion.step
                    : s.box.lo.y - p_.bodyTop - 1.5f * p_.touchMargin - limits_.slack;
    if (s.carries) s.takeOff = heldOver(s);
    return s;
  }

  // Returns the max take-off where a ceiling stops a jump or an edge holds the torso. Landings
  // there are slow.
  float heldOver(const Support& s) const {
    const float near = 2 * limits_.body + limits_.walk * 0.15f;
    float limit = 0;
    solids_.any(grow(s.box, {near, 1e6f, near}), [&](uint32_t id) {
      if (id == s.collider) return false;
      const Box& box = motions_[id].swept;
      const bool exact = beside_[id] != Beside::deep && motions_[id].step == 0;
      // Heights of the feet when the part stops a body; `play` is how much lower they may be.
      const float under = (exact ? box.lo.y - p_.bodyTop : box.hi.y) - s.top();
      const float over = box.hi.y - p_.hipHeight - s.top();
      const float play = limits_.slack + (exact ? 0 : box.hi.y - box.lo.y + p_.bodyTop);
      limit = std::max(limit, limits_.takeOff(under - play, under + limits_.slack));
      if (over - play < limits_.maxTakeOff) {
        limit = std::max(limit, limits_.takeOff(over - play, over));
      }
      return false;
    });
    return limit;
  }

  const level::LevelView& level_;
  const Params& p_;
  const BodyLimits& limits_;
  const std::vector<PartMotion>& motions_;
  const BoxIndex solids_;       // (colliders)
  std::vector<Beside> beside_;  // (colliders)
  std::vector<Box> pressed_;    // (colliders), where a body may be inside a deep part
  std::vector<bool> grown_;     // (colliders), true if pressed_ has grown since the last push
  float climb_ = 0;             // climbing speed on a truss, studs/s
  std::vector<Support> supports_;
};

}  // namespace

bool isAxial(const level::LevelView& level, uint32_t collider) {
  const Vec3 x = level.colliders[collider].pose.rotation.x;
  return (level.bounds[collider].flags & level::kUpright) && std::min(absf(x.x), absf(x.z)) < 1e-5f;
}

std::vector<Support> supportsOf(const Problem& problem, const BodyLimits& limits,
                                const std::vector<PartMotion>& motions) {
  return Builder(problem, limits, motions).build();
}

}  // namespace obby::solve

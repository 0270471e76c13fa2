// Slopes make a player faster than keys do: they turn speed upward, and speed upward aside.
#include <algorithm>
#include <utility>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/box_index.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

namespace {

// Can somebody come under a face of it that is neither level nor upright?
bool facesDown(const level::Collider& c) {
  using geom::ShapeKind;
  constexpr float kUpright = 0.999f;
  if (c.mover != level::kNone) return true;
  const Mat3& axes = c.pose.rotation;
  const float x = absf(axes.x.y);
  switch (c.kind) {
    case ShapeKind::block: return std::max({x, absf(axes.y.y), absf(axes.z.y)}) < kUpright;
    case ShapeKind::cylinder: return x < kUpright;
    case ShapeKind::wedge:
    case ShapeKind::cornerWedge: return axes.y.y < kUpright;
    default: return true;
  }
}

// How high such a face can be.
float highestUnder(const level::Collider& c, const Box& box) {
  const bool curved = c.kind == geom::ShapeKind::ball || c.kind == geom::ShapeKind::cylinder;
  return curved && c.mover == level::kNone ? 0.5f * (box.lo.y + box.hi.y) : box.hi.y;
}

}  // namespace

// Speed is kept in the air, on ice and for a moment after landing: what is gained anywhere counts
// everywhere.
float ReachBound::fastestReached() const {
  float more = 0, given = 0, upward = 0;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Support& s = supports_[i];
    more = std::max(more, s.sideways);
    if (!isSteepOnly(s)) given = std::max(given, s.sideways);
    upward = std::max(upward, launch(s).upward);
  }
  const float all = fastestOfAll(), most = std::max(all, flight_.sideways());
  if (!slopes_) return std::min(walkSpeed_ + more, most);
  // Keys that brake less than slopes make fast let a slide grow without end.
  const bool slides = p_.airAccel < 0.5f * p_.gravity;
  if (slides || anyHelpless(problem_.level) || glancesFar(upward, all - walkSpeed_)) return most;
  return std::min(walkSpeed_ + turnedAside(given, more), most);
}

// Does it give speed by its steepness alone?
bool ReachBound::isSteepOnly(const Support& s) const {
  constexpr uint32_t kGives = level::kConveyor | level::kCarries | level::kSeat | level::kPad;
  return s.tilted && !(problem_.level.bounds[s.collider].flags & kGives);
}

// Is it a floor on which keys hardly slow down?
bool ReachBound::isIce(const Support& s) const {
  return s.carries && problem_.level.colliders[s.collider].grip < p_.plainGrip;
}

// Clamped along each axis.
float ReachBound::fastestOfAll() const { return 1.42f * problem_.level.maxSideSpeed; }

// A slope overhead turns half of the speed upward aside, on ice again and again. Keys take that
// back within so many studs: more than a flight that ends there loses, and than what steep faces
// are granted? Who fell over has no legs to brace, and no keys to slow down with.
bool ReachBound::glancesFar(float upward, float most) const {
  const float jump = mayJump_ ? std::min(upward, jumpSpeed_) : 0.0f;
  const auto isFar = [&](float gained) {
    const float studs = gained * gained / (2 * std::max(p_.airAccel, 1e-3f));
    return studs > kFeetSpare + kSteepSpeed * jump / p_.gravity;
  };
  const float always = std::max(most, 0.0f), once = std::min(0.5f * upward, always);
  return isFar(once) || (isFar(always) && glancesOver(true));
}

// Is a slope overhead within a jump of what is reached, of ice only?
bool ReachBound::glancesOver(bool ice) const {
  const level::LevelView& level = problem_.level;
  std::vector<Box> slopes;
  std::vector<uint32_t> ids;  // (slopes)
  for (const Support& s : supports_) {
    if (!s.tilted || !facesDown(level.colliders[s.collider])) continue;
    Box box = level.bounds[s.collider].box();
    box.hi.y = highestUnder(level.colliders[s.collider], box);
    slopes.push_back(box);
    ids.push_back(s.collider);
  }
  if (slopes.empty()) return false;
  const BoxIndex index(std::move(slopes));
  bool found = false;
  for (size_t i = 0; i < supports_.size() && !found; ++i) {
    const Support& s = supports_[i];
    if (jumps_[i] == kNever || !s.carries) continue;
    if (ice && !isIce(s)) continue;
    const Launch l = launch(s);
    const float head = flight_.apex(l) + p_.bodyTop, hips = s.entry + p_.hipHeight;
    // From ice to ice they come aside, too.
    const float far = ice ? flight_.reach(l, flight_.apex(l)) : 0.0f;
    const float side = bodySide(p_) + kSlack + std::max(far, 0.0f);
    const Box over{{s.feet.lo.x - side, hips, s.feet.lo.z - side},
                   {s.feet.hi.x + side, std::max(head, hips), s.feet.hi.z + side}};
    index.find(over, [&](uint32_t slope) { found |= ids[slope] != s.collider; });
  }
  return found;
}

// Studs/s upward at which slopes let go of somebody who runs up them: one after the other they turn
// nearly all of the speed upward, and on the way up keys hold as much against gravity.
float ReachBound::rampSpeed(const Support& s) const {
  constexpr float kSpare = 1.05f;
  if (!s.tilted && !(s.keepsSpeed && slopes_)) return 0;
  return flight_.sideways() * std::max(1.0f, kSpare * p_.traction * p_.plainGrip / p_.gravity);
}

}  // namespace obby::solve

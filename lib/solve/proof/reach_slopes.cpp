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
  float more = 0, upward = 0;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    more = std::max(more, supports_[i].sideways);
    upward = std::max(upward, launch(supports_[i]).upward);
  }
  const float most = fastestOfAll();
  if (slopes_ && (anyHelpless(problem_.level) || glancesFar(upward, most - walkSpeed_))) {
    return std::max(most, flight_.sideways());
  }
  return std::min(walkSpeed_ + more, std::max(most, flight_.sideways()));
}

// Clamped along each axis.
float ReachBound::fastestOfAll() const { return 1.42f * problem_.level.maxSideSpeed; }

// A slope overhead turns half of the speed upward aside, on ice again and again. Keys take that
// back within so many studs: more than a flight that ends there loses, and than what steep faces
// are granted? Who fell over has no legs to brace, and no keys to slow down with.
bool ReachBound::glancesFar(float upward, float most) const {
  constexpr float kSpare = 1.5f;  // studs that a support's feet are granted beyond the truth
  const auto isFar = [&](float gained) {
    const float studs = gained * gained / (2 * std::max(p_.airAccel, 1e-3f));
    return studs > kSpare + kSteepSpeed * upward / p_.gravity;
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
  const float side = bodySide(p_) + kSlack;
  bool found = false;
  for (size_t i = 0; i < supports_.size() && !found; ++i) {
    const Support& s = supports_[i];
    if (jumps_[i] == kNever || !s.carries) continue;
    if (ice && !(level.colliders[s.collider].friction < p_.iceFriction)) continue;
    const float head = flight_.apex(launch(s)) + p_.bodyTop, hips = s.entry + p_.hipHeight;
    const Box over{{s.feet.lo.x - side, hips, s.feet.lo.z - side},
                   {s.feet.hi.x + side, std::max(head, hips), s.feet.hi.z + side}};
    index.find(over, [&](uint32_t slope) { found |= ids[slope] != s.collider; });
  }
  return found;
}

// Studs/s upward at which a slope lets go of somebody who runs up it: it turns half of the speed
// upward at once, and on the way up keys hold as much against gravity.
float ReachBound::rampSpeed(const Support& s) const {
  constexpr float kSpare = 1.05f;
  if (!s.tilted && !(s.keepsSpeed && slopes_)) return 0;
  return flight_.sideways() * std::max(0.5f, kSpare * p_.groundAccel / p_.gravity);
}

}  // namespace obby::solve

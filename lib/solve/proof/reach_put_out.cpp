#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "solve/proof/body_reach.h"
#include "solve/proof/jumping.h"
#include "solve/proof/reach_bound.h"

namespace obby::solve {

std::vector<Ride> ReachBound::ownRides(const Box& from) const {
  std::vector<Ride> open;
  for (const Pusher& by : pushers_) {
    if (by.bursts) open.push_back({&by, gapBetween(from, by.pushed)});
  }
  return nearestFirst(std::move(open), std::numeric_limits<float>::infinity());
}

std::vector<PutOut> ReachBound::putOuts() const {
  float apex = problem_.start.position.y, upward = 0;
  for (size_t i = 0; i < supports_.size(); ++i) {
    if (jumps_[i] == kNever) continue;
    const Launch l = launch(supports_[i]);
    apex = std::max(apex, flight_.apex(l));
    upward = std::max(upward, l.upward);
  }
  std::vector<Footing> floors;
  const bool anyJumps = mayJump_ || jumpingIn(problem_) == Jumping::unseen;
  for (size_t i = 0; i < supports_.size(); ++i) {
    const Support& s = supports_[i];
    if (!anyJumps || jumps_[i] == kNever || !s.carries) continue;
    // The torso does not collide for three ticks, or until a floor has been felt for the last time.
    const float feet = launch(s, true).from.hi.y + 3 * upward * p_.tickSeconds;
    floors.push_back({s.collider, feet + p_.headBottom});
  }
  std::vector<PutOut> outs =
      putOutsOf(problem_.level, floors, {problem_.start.position, apex, fastest()});
  // Somebody may be near any of them for nothing.
  const bool bursts =
      std::any_of(pushers_.begin(), pushers_.end(), [](const Pusher& by) { return by.bursts; });
  for (PutOut& out : outs) out.away = bursts ? 0.0f : out.away;
  return outs;
}

}  // namespace obby::solve

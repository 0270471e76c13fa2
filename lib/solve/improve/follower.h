// Steers a player along a guide: looks ahead, jumps where the guide does, and lands where it lands.
#pragma once

#include "solve/improve/guide.h"

namespace obby::solve {

struct FollowSettings {
  uint32_t lookahead = 15;  // ticks along the guide; more cuts more corners
  int slack = 512;          // turns / 65536 by which the direction may be off before keys change
  bool synced = false;      // be at each point at its time, for levels that move
};

class Follower {
 public:
  Follower() = default;
  // Begins at point `start` of a guide, after `last`.
  Follower(uint32_t start, const FollowSettings& settings, const sim::World& world,
           const sim::Action& last);

  // Returns the keys for the next tick. The guide must be the same at each call.
  sim::Action next(const Guide& guide, const sim::World& w, const Params& params);

  uint32_t at() const { return at_; }  // the nearest point of the guide

 private:
  void advance(const sim::World& w);
  uint32_t nearest(Vec3 position) const;
  bool wantsJump(const sim::World& w, bool onGround);
  uint32_t aim(bool onGround) const;
  void steer(const sim::World& w, bool onGround, const Params& params);
  const GuidePoint& here() const { return guide_->points[at_]; }

  const Guide* guide_ = nullptr;  // valid within next()
  FollowSettings settings_;
  uint32_t at_ = 0;
  bool first_ = true;
  uint32_t pending_ = 0;  // ticks for which a jump is still wanted
  uint32_t jumps_ = 0;    // made by the player at the last tick
  sim::Action held_;
};

}  // namespace obby::solve

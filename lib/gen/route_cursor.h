// The route of a level under construction: its edge, where the last floor ends, and the points
// that it has passed. Offsets are right, up and forward of the edge.
#pragma once

#include <vector>

#include "gen/part_sketch.h"
#include "math/angle.h"

namespace obby::gen {

class RouteCursor {
 public:
  void advance(float forward, float up = 0, float right = 0);
  Vec3 at(Vec3 from) const;
  Vec3 direction(Vec3 local) const;  // right, up, forward; returns a world vector
  Turns heading() const { return heading_; }
  Quat facing() const;
  // Adds a point of the intended route between two stops, for learning. The route need not be
  // straight.
  void via(Vec3 from) { line_.push_back(at(from)); }
  // Lengthens the estimate of the route, in studs.
  void expectRoute(float studs) { along_ += studs; }
  // Returns true if the route has not turned yet. After a turn, a wall too wide to go round may be
  // close enough to jump onto from the lane before the turn.
  bool straight() const { return !turned_; }
  // Returns the route from the start to the goal, through all stops and the points between.
  const std::vector<Vec3>& line() const { return line_; }

 protected:
  // Turns to `heading` about the center of a disc of that diameter, whose far side is the edge.
  void turnAbout(float diameter, Turns heading);

  Vec3 edge_;
  Turns heading_ = 0;
  bool turned_ = false;
  std::vector<Vec3> line_;
  float along_ = 0;  // studs
};

}  // namespace obby::gen

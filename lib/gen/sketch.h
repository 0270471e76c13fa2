// A level under construction. Each part is placed relative to the edge, where the last floor ends.
//
// Offsets are along the route: right, up and forward of the edge. The edge is the middle of the
// last floor's far side, at the height of its top. Gaps and rises are shares of what the physics
// parameters allow. Those shares follow the difficulty.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "gen/draws.h"
#include "gen/part_sketch.h"
#include "gen/reach.h"
#include "gen/route_cursor.h"

namespace obby::gen {

// A floor between obstacles. It can hold a waypoint, a checkpoint or the goal.
struct Stop {
  uint32_t part;
  Vec3 feet;     // middle of its top
  Vec3 extents;  // full extents of the region in which a player stands on the floor
  Turns heading;
};

// The plan of a sketch. `planted` is the index of the crossing to make impossible, or -1 for none.
struct SketchPlan {
  int planted = -1;
  float fastest = 0;  // studs/s: the max speed that belts and carriers add to a player
};

constexpr float kProof = 1.15f;  // factor by which a falling player may exceed Reach in a proof of
                                 // `unreachable`

class Sketch : public Draws, public RouteCursor {
 public:
  // Both must outlive the sketch.
  Sketch(const Reach& reach, const Recipe& recipe, Random random, SketchPlan plan);

  // --- Measures. Each is a crossing that can be made impossible.
  float gap(float rise = 0, float share = 1);
  float rise(float share = 1);
  // Returns a rise like that of rise(), but one that is never impossible.
  float easyRise(float share = 1);
  // Returns the height of a ledge beyond any jump, which needs a tool to climb.
  float highLedge(const Parameter& beyond);
  // Returns true if this crossing is to be impossible. The style then leaves out the tool, but
  // draws the same random numbers, so that the rest equals the solvable level.
  bool broken(const char* what);
  // Returns a gap that is never impossible, for styles with several routes.
  float sideGap(float share = 1);
  // Returns the studs by which an impassable wall extends beyond its floor on either side. The
  // result is at least `min`. It is so large that no player gets round the wall, whether from its
  // floor or from earlier parts to the side.
  float roundabout(float min) const;

  // --- Parts
  // `from`: right, up and forward from the edge to the part's center. `size`: along the same axes.
  PartSketch& part(const char* name, Vec3 from, Vec3 size);
  // Adds a floor one stud thick across a gap, `right` of the route. The edge moves to its far side.
  PartSketch& floor(const char* name, float length, float width, float gap = 0, float up = 0,
                    float right = 0);
  // Adds a round floor, after which the route may turn.
  PartSketch& disc(const char* name, float diameter, float gap = 0, float up = 0);
  // Adds a wall on a floor. Its foot is at height `up` and reaches half a stud into the floor.
  PartSketch& wall(const char* name, float right, float forward, float width, float height,
                   float thickness, float up = 0);
  // Returns a motion to and fro between two points (right, up, forward of the edge).
  MotionSketch slide(Vec3 from, Vec3 to, float seconds, float offset);
  static PartSketch& deadly(PartSketch& part);

  // Turns the route about the center of a disc of that diameter, whose far side is the edge.
  void bend(float diameter);
  // Estimates for the limits of the query.
  void expectJumps(uint32_t jumps) { jumps_ += jumps; }
  void expectWait(float seconds) { waits_ += seconds; }

  // --- The frame around the obstacles
  void start();
  void begin(float difficulty);  // starts the next obstacle; difficulty 0 to 1
  // Adds the floor after an obstacle: the goal, or a checkpoint after which the route may turn.
  void rest(bool last, bool mayTurn);

  const Reach& reach() const { return *reach_; }
  const std::vector<PartSketch>& parts() const { return parts_; }
  const std::vector<Stop>& stops() const { return stops_; }  // the start first, the goal last
  int crossings() const { return crossings_; }
  const std::string& plantedWhat() const { return plantedWhat_; }
  float fastest() const { return fastest_; }
  uint32_t jumps() const { return jumps_; }
  float seconds() const;  // returns the estimated time of a steady player, seconds
  // Returns the color of the current theme's next floor.
  Color shade();
  // Returns a name such as "door 2", shared by a button and the parts that the button controls.
  std::string signal(const char* kind);
  // Notes that a part carries or throws players at this speed, studs/s.
  void noteCarrier(float speed) { fastest_ = maxf(fastest_, speed); }

 private:
  std::string numbered(const char* name);
  float beyond();
  void stop(uint32_t part, float length, Vec3 extents);

  struct Numbered {
    const char* name;
    uint32_t used;
  };

  const Reach* reach_;
  Random excess_;  // separate, so that an unsolvable twin differs only in its impossible crossing
  SketchPlan plan_;
  float bendSide_ = 1;  // a level turns to one side only, so that its lanes never meet
  uint32_t theme_ = 0;
  uint32_t shades_ = 0;
  std::vector<PartSketch> parts_;
  std::vector<Stop> stops_;
  std::vector<Numbered> names_;
  int crossings_ = 0;
  std::string plantedWhat_;
  float fastest_ = 0;
  uint32_t jumps_ = 0;
  float waits_ = 0;
};

}  // namespace obby::gen

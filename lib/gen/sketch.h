// A level under construction. Each part is placed relative to the edge, where the last floor ends.
//
// Lengths are along the route: right, up and forward of the edge. The edge is the middle of the
// last floor's far side, at the height of its top. Gaps and rises are shares of what the physics
// parameters allow. Those shares follow the difficulty.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "base/random.h"
#include "gen/part_sketch.h"
#include "gen/reach.h"
#include "gen/recipe.h"
#include "gen/style.h"
#include "math/angle.h"

namespace obby::gen {

// A floor between obstacles. It can hold a waypoint, a checkpoint or the goal.
struct Stop {
  uint32_t part;
  Vec3 feet;  // middle of its top
  Vec3 room;  // full extents of the region in which a player stands on it
  Turns heading;
};

// `planted` is the index of the crossing to make impossible; -1: none.
struct SketchPlan {
  int planted = -1;
  float fastest = 0;  // studs/s: the max speed that belts and carriers add to a player
};

constexpr float kProof = 1.15f;  // factor by which a falling player may exceed Reach in a proof of
                                 // `unreachable`

class Sketch {
 public:
  // Both must outlive the sketch.
  Sketch(const Reach& reach, const Recipe& recipe, Random random, SketchPlan plan);

  // --- Random numbers. At most one draw per expression, because compilers order the evaluation of
  // operands and arguments differently, and levels would differ.
  float unit() { return random_.unit(); }
  uint32_t below(uint32_t n) { return random_.below(n); }
  uint32_t count(Count c) { return c.lo + random_.below(c.hi - c.lo + 1); }
  bool chance(float share) { return random_.unit() < share; }
  float side() { return random_.below(2) == 0 ? -1.0f : 1.0f; }
  // Returns a value between easy and hard by the difficulty and some noise, in quarters.
  float mix(const Parameter& p);
  // Like mix(), with a random sign.
  float mixEitherSign(const Parameter& p) { return eitherSign(endsOf(p)); }
  float mixEitherSign(float easy, float hard) { return eitherSign({easy, hard}); }
  // Like mix(), but returns a spin in rad/s with a random sign. A turn takes a whole number of
  // ticks at 60 a second, which keeps the turn tables short (kMaxLevelRows of lib/level).
  float mixSpin(const Parameter& p);
  // Like mix(), but returns a whole number.
  uint32_t mixCount(const Parameter& p);
  // Depends on the difficulty alone, without noise.
  float steady(const Parameter& p) const;

  // --- Measures. Each is a crossing that can be made impossible.
  float gap(float rise = 0, float share = 1);
  float rise(float share = 1);
  // Like rise(), but never impossible.
  float easyRise(float share = 1);
  // Returns the height of a ledge beyond any jump, which needs a tool to climb.
  float highLedge(const Parameter& beyond);
  // Returns true if this crossing is to be impossible. The style then leaves out the tool, but
  // draws the same random numbers, so that the rest equals the solvable level.
  bool broken(const char* what);
  // Returns true if the route has not turned yet. After a turn, a wall too wide to go round may be
  // close enough to jump onto from the lane before the turn.
  bool straight() const { return !turned_; }
  // A gap that is never impossible, for styles with several routes.
  float sideGap(float share = 1);
  // Returns the studs by which an impassable wall extends beyond its floor on either side. The
  // result is at least `least`, and large enough that no player gets round the wall, neither from
  // its floor nor from earlier parts to the side.
  float roundabout(float least) const;

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

  // --- The route
  void advance(float forward, float up = 0, float right = 0);
  // Turns the route about the center of a disc of that diameter, whose far side is the edge.
  void bend(float diameter);
  Vec3 at(Vec3 from) const;
  Vec3 direction(Vec3 local) const;  // right, up, forward; returns a world vector
  Turns heading() const { return heading_; }
  Quat facing() const;
  // Adds a point of the intended route between two stops, for learning. The route need not be
  // straight.
  void via(Vec3 from) { line_.push_back(at(from)); }
  // Estimates for the limits of the query.
  void expectJumps(uint32_t jumps) { jumps_ += jumps; }
  void expectWait(float seconds) { waits_ += seconds; }
  void expectWay(float studs) { way_ += studs; }

  // --- The frame around the obstacles
  void start();
  void begin(float difficulty);  // of the next obstacle, 0 to 1
  // Adds the floor after an obstacle: the goal, or a checkpoint after which the route may turn.
  void rest(bool last, bool mayTurn);

  float difficulty() const { return difficulty_; }
  const Reach& reach() const { return *reach_; }
  const std::vector<PartSketch>& parts() const { return parts_; }
  const std::vector<Stop>& stops() const { return stops_; }  // the start first, the goal last
  // Returns the route from the start to the goal, through all stops and the points between.
  const std::vector<Vec3>& line() const { return line_; }
  int crossings() const { return crossings_; }
  const std::string& plantedWhat() const { return plantedWhat_; }
  float fastest() const { return fastest_; }
  uint32_t jumps() const { return jumps_; }
  float seconds() const;  // estimate for a steady player
  // Returns the color of the current theme's next floor.
  Color shade();
  // Returns a name such as "door 2", shared by a button and the parts it controls.
  std::string signal(const char* kind);
  // Notes that a part carries or throws players at this speed, studs/s.
  void noteCarrier(float speed) { fastest_ = maxf(fastest_, speed); }

 private:
  // Values at difficulty 0 and 1.
  struct Ends {
    float easy, hard;
  };
  Ends endsOf(const Parameter& p) const;
  float mixed(Ends ends);
  float eitherSign(Ends ends);
  std::string numbered(const char* name);
  float share(float spread);
  float beyond();
  void stop(uint32_t part, float length, Vec3 room);

  struct Numbered {
    const char* name;
    uint32_t used;
  };

  const Reach* reach_;
  const Recipe* recipe_;
  Random random_;
  Random excess_;  // separate, so that an unsolvable twin differs only in its impossible crossing
  SketchPlan plan_;
  float difficulty_ = 0;
  Vec3 edge_;
  Turns heading_ = 0;
  bool turned_ = false;
  float bendSide_ = 1;  // a level turns to one side only, so that its lanes never meet
  uint32_t theme_ = 0;
  uint32_t shades_ = 0;
  std::vector<PartSketch> parts_;
  std::vector<Stop> stops_;
  std::vector<Vec3> line_;
  std::vector<Numbered> names_;
  int crossings_ = 0;
  std::string plantedWhat_;
  float fastest_ = 0;
  uint32_t jumps_ = 0;
  float way_ = 0, waits_ = 0;
};

}  // namespace obby::gen

// A level while it is being made: parts in a row, each placed from the edge where the last floor
// ends.
//
// Lengths are given along the way: right, up and forward of the edge, which is the middle of the
// far side of the last floor, at the height of its top. How hard an obstacle is comes from
// measures: a gap or a rise is a share of what the physics parameters allow, and that share follows
// the difficulty.
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

// A floor between obstacles: where a waypoint, a checkpoint or the goal may be.
struct Stop {
  uint32_t part;
  Vec3 feet;  // middle of its top
  Vec3 room;  // full extents of the space in which one who stands there is
  Turns heading;
};

// What a sketch is of. `planted` is the crossing that nobody can pass; -1: none.
struct SketchPlan {
  int planted = -1;
  float fastest = 0;  // studs/s that belts and carriers add to a player, at most
};

constexpr float kProof = 1.15f;  // what a proof of `unreachable` allows a falling player more

class Sketch {
 public:
  // Both must outlive the sketch.
  Sketch(const Reach& reach, const Recipe& recipe, Random random, SketchPlan plan);

  // --- random numbers. At most one draw an expression: compilers evaluate operands and arguments
  // in orders of their own, and levels would differ.
  float unit() { return random_.unit(); }
  uint32_t below(uint32_t n) { return random_.below(n); }
  uint32_t count(Count c) { return c.lo + random_.below(c.hi - c.lo + 1); }
  bool chance(float share) { return random_.unit() < share; }
  float side() { return random_.below(2) == 0 ? -1.0f : 1.0f; }
  // From what is easy to what is hard, by the difficulty and a little chance; whole quarters.
  float mix(const Parameter& p);
  // The same, with either sign.
  float mixEitherSign(const Parameter& p) { return eitherSign(endsOf(p)); }
  float mixEitherSign(float easy, float hard) { return eitherSign({easy, hard}); }
  // A speed of turning, rad/s, with either sign. A turn takes a whole number of ticks at 60 a
  // second, so that tables of turns are short (kMaxLevelRows of lib/level).
  float mixSpin(const Parameter& p);
  // The same as a whole number.
  uint32_t mixCount(const Parameter& p);
  // By the difficulty alone.
  float steady(const Parameter& p) const;

  // --- measures: each is a crossing, which can be planted to be beyond reach
  float gap(float rise = 0, float share = 1);
  float rise(float share = 1);
  // The same, never planted.
  float easyRise(float share = 1);
  // A ledge that needs something: so many studs beyond a jump.
  float highLedge(const Parameter& beyond);
  // Is this crossing to be made impossible? The style leaves out what it takes, and draws the same
  // numbers nevertheless: all else of a twin is as it was.
  bool broken(const char* what);
  // Has the way come straight so far? Beside a lane that comes from aside, a wall that is too wide
  // to go round is near enough to be jumped onto.
  bool straight() const { return !turned_; }
  // A gap that is never planted: there are other ways.
  float sideGap(float share = 1);
  // Studs that a wall which nobody may pass reaches beyond its floor to either side: `least`, where
  // that is more than the widest gap; else so many that nobody gets round its end, neither from the
  // floor nor from what lies aside before it, wherever the way goes behind it.
  float roundabout(float least) const;

  // --- parts
  // `from`: right, up, forward of the edge to the middle of the part. `size`: along the same.
  PartSketch& part(const char* name, Vec3 from, Vec3 size);
  // A floor one stud thick across a gap, its middle `right` of the way; the edge moves to its far
  // side.
  PartSketch& floor(const char* name, float length, float width, float gap = 0, float up = 0,
                    float right = 0);
  // A round floor, after which the way may turn.
  PartSketch& disc(const char* name, float diameter, float gap = 0, float up = 0);
  // A wall on a floor: its foot at height `up`, reaching down half a stud into the floor.
  PartSketch& wall(const char* name, float right, float forward, float width, float height,
                   float thickness, float up = 0);
  // There and back between two points of the way (right, up, forward of the edge).
  MotionSketch slide(Vec3 from, Vec3 to, float seconds, float offset);
  static PartSketch& deadly(PartSketch& part);

  // --- the way
  void advance(float forward, float up = 0, float right = 0);
  // Turns about the middle of a disc of that diameter, whose far side is the edge.
  void bend(float diameter);
  Vec3 at(Vec3 from) const;
  Vec3 direction(Vec3 local) const;  // right, up, forward as a vector of the world
  Turns heading() const { return heading_; }
  Quat facing() const;
  // Where a player passes between two stops, for those who are to learn: the way is no straight
  // line.
  void via(Vec3 from) { line_.push_back(at(from)); }
  // For the limits of the query.
  void expectJumps(uint32_t jumps) { jumps_ += jumps; }
  void expectWait(float seconds) { waits_ += seconds; }
  void expectWay(float studs) { way_ += studs; }

  // --- the frame round the obstacles
  void start();
  void begin(float difficulty);  // of the next obstacle
  // A floor behind it: a checkpoint, after which the way may turn, or the goal.
  void rest(bool last, bool mayTurn);

  float difficulty() const { return difficulty_; }
  const Reach& reach() const { return *reach_; }
  const std::vector<PartSketch>& parts() const { return parts_; }
  const std::vector<Stop>& stops() const { return stops_; }  // the start first, the goal last
  // From the start to the goal, through all stops and what lies between.
  const std::vector<Vec3>& line() const { return line_; }
  int crossings() const { return crossings_; }
  const std::string& plantedWhat() const { return plantedWhat_; }
  float fastest() const { return fastest_; }
  uint32_t jumps() const { return jumps_; }
  float seconds() const;  // that a steady player takes, about
  // Of the kind of floor that this obstacle has.
  Color shade();
  // "door 2": for a button and what it works.
  std::string signal(const char* kind);
  // Something on the way carries or throws players that fast, studs/s.
  void noteCarrier(float speed) { fastest_ = maxf(fastest_, speed); }

 private:
  // At no difficulty and at all of it.
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
  Random excess_;  // apart, so that a twin differs in its planted crossing only
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

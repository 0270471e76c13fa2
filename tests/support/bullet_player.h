// A player of a game made with Bullet: recordings by an engine that nobody here wrote, whose rules
// are not the simulator's. Its body is a capsule; it has no legs, no floor rays and no states.
#pragma once

#include "calibrate/manoeuvres.h"

namespace obby::test {

// What such a game sets, and a fit does not know. Studs and seconds.
struct BulletGame {
  // `kinematic`: Bullet's own character controller, which the game tells how far to go in each
  // step; the game changes that by a constant acceleration. `dynamic`: a rigid body, on which the
  // game puts a force in proportion to the velocity that is lacking.
  enum class Body { kinematic, dynamic };
  Body body = Body::kinematic;
  float walkSpeed = 16, jumpSpeed = 50, gravity = 196;
  float groundAccel = 200, airAccel = 120;  // studs/s^2 of the kinematic one
  float groundGain = 15, airGain = 5;       // 1/s of the dynamic one
  float damping = 0;                        // share of the velocity that is lost in a second
  float radius = 1, height = 5;
  float stepHeight = 0.35f;  // of the kinematic one
};

// Others than the defaults above, each drawn within a share of it.
BulletGame drawnGame(BulletGame::Body body, uint64_t seed, float spread);

// The calibration course as such a game has it: the blocks that stand still, none of them ice. What
// its player goes through must not be in the level that is fitted.
void writeBulletCourse(schema::Level::Builder to);

// Manoeuvres of the calibration course that need no more than such a game has: it knows no trusses,
// no ice, and nothing that moves, and its player climbs no step higher than `stepHeight`, where
// legs would take them up.
std::vector<calibrate::Manoeuvre> bulletManoeuvres();

// The manoeuvre in this game, in steps of 1/240 s, a frame every fourth. Positions are of the
// capsule's centre; whoever falls far below the start is out, and not recorded further. Of the
// level it has the blocks that stand still, and nothing else.
calibrate::Track playedByBullet(const BulletGame& game, const level::Level& level,
                                const calibrate::Manoeuvre& manoeuvre);

}  // namespace obby::test

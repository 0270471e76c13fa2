// A player in a game made with Bullet: recordings by an independent engine whose rules differ from
// the simulator's. The player's body is a capsule without legs, floor rays or states.
#pragma once

#include "calibrate/manoeuvres.h"

namespace obby::test {

// Parameters of the game, in studs and seconds. The fit does not know them.
struct BulletGame {
  // `kinematic`: Bullet's character controller, which is given the distance of each step. The game
  // changes its velocity with a constant acceleration. `dynamic`: a rigid body, driven by a force
  // in proportion to the missing velocity.
  enum class Body { kinematic, dynamic };
  Body body = Body::kinematic;
  float walkSpeed = 16, jumpSpeed = 50, gravity = 196;
  float groundAccel = 200, airAccel = 120;  // studs/s^2, kinematic body
  float groundGain = 15, airGain = 5;       // 1/s, dynamic body
  float damping = 0;                        // share of the velocity that is lost in a second
  float radius = 1, height = 5;
  float stepHeight = 0.35f;  // kinematic body
};

// Draws each parameter within the share `spread` of its default above.
BulletGame drawnGame(BulletGame::Body body, uint64_t seed, float spread);

// Writes the parts of the calibration course that exist in the game: the static blocks except ice.
// The fitted level must not contain anything that the game's player passes through.
void writeBulletCourse(schema::Level::Builder to);

// Returns the manoeuvres of the calibration course that this game supports. It has no trusses, ice
// or moving parts, and its player cannot climb steps higher than `stepHeight`.
std::vector<calibrate::Manoeuvre> bulletManoeuvres();

// Returns a recording of the manoeuvre in this game, with steps of 1/240 s and a frame every fourth
// step. Positions are of the capsule's centre. The recording ends if the player falls far below the
// start. Only the level's static blocks are used.
calibrate::Track playedByBullet(const BulletGame& game, const level::Level& level,
                                const calibrate::Manoeuvre& manoeuvre);

}  // namespace obby::test

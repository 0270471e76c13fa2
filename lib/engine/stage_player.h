// The player of a running place: its moves, and what scripts read of it. Private to lib/engine.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "engine/document.h"
#include "engine/host.h"

namespace obby::engine {

class StagePlayer {
 public:
  // Puts the player's feet at a position; yaw in radians, 0 looks along -Z.
  void stand(Vec3 feet, float yaw);
  // Stands on top of a part, or with the root's middle in the part's middle (`inside`). `share`:
  // offset as a share of the distance to a corner. `face`: 1, 2, 3 put the root's middle just
  // outside the face toward X, Y, Z, so that only limbs are in the part. `speed`: fall speed,
  // studs/s.
  void standAt(InstanceId part, bool inside, float share, int face = 0, float speed = 0);
  // Stands in the air far above the spawn, where no part is.
  void standAway();
  // Ends all touches of the player's body. They begin again in the next frame, as on a walk.
  void touchAgain();
  // Returns the player to the spawn.
  void leave();
  // Clicks a ClickDetector or a button, holds a ProximityPrompt, activates a tool or presses keys.
  // Returns true if the use lasts until release().
  bool use(InstanceId target);
  void release(InstanceId target);
  // drop() steps off an edge of that height (studs); walk() begins or ends a walk on the spot;
  // enter() enters a HumanoidStateType. Call fly() before each frame: it returns false once the
  // player has landed.
  void drop(float height);
  void jump() { call("moves", "jump", 0); }
  bool fly();
  void walk(bool on);
  void enter(const char* state);
  // Returns true if scripts look at the player's moves.
  bool heedsMoves() { return numberOf("heedsMoves") > 0; }
  // takeOff(), fall() and land() set the humanoid's state without moving the body. pressJump()
  // presses the jump key.
  void takeOff();
  void fall();
  void land();
  void pressJump();
  bool hearsJumps();
  bool playerLives();
  // Returns true if scripts look at where the player is.
  bool looksAtPlayer() { return numberOf("looksAtPlayer") > 0; }
  // Returns true if scripts listen for new bodies of the player. Only then can they place them.
  bool hearsNewBodies() { return numberOf("hearsNewBodies") > 0; }
  void die();
  double respawnTime() { return numberOf("respawnTime"); }  // seconds, of the Players service
  // Gives a player that died at its spawn a new body, away from everything.
  void revive();
  // Ends the player's force fields.
  void unshield();

 protected:
  StagePlayer(const Document& document, const Settings& settings)
      : host_(std::make_unique<Host>(document, settings)) {}

  // Calls a function of a file of api/ with `arguments` values from the top of the stack.
  void call(const char* module, const char* name, int arguments, int results = 0);
  double numberOf(const char* name, const char* module = "probe", int arguments = 0);
  void note(const std::string& what, const Error& error);

  std::unique_ptr<Host> host_;
};

}  // namespace obby::engine

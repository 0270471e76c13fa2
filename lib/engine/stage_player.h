// The player of a running place: what it does, and what scripts look at. Private to lib/engine.
#pragma once

#include <memory>
#include <string>

#include "base/result.h"
#include "engine/document.h"
#include "engine/host.h"

namespace obby::engine {

class StagePlayer {
 public:
  // Puts the player's feet there; yaw in radians, 0 looks along -Z.
  void stand(Vec3 feet, float yaw);
  // On top of a part, or its middle in the middle of the part, wherever that is by now.
  // `share`: how far off, as a share of the distance to a corner. `face`: 1, 2, 3 put the root's
  // middle just outside of the part instead, before its face toward X, Y, Z: then limbs alone are
  // in the part.
  // `speed`: of a fall, studs/s.
  void standAt(InstanceId part, bool inside, float share, int face = 0, float speed = 0);
  // In the air far above the spawn, where no part is.
  void standAway();
  // All that touches the player's body ends and begins again in the next frame, as where it walks.
  void touchAgain();
  // Back to the spawn.
  void leave();
  // Clicks a ClickDetector or a button, holds a ProximityPrompt, activates a tool, presses keys.
  // Returns true if that goes on until release().
  bool use(InstanceId target);
  void release(InstanceId target);
  // The player steps off an edge of that height, jumps, begins or ends to walk on the spot, or
  // enters a HumanoidStateType. fly() before each frame; returns false once the player has landed.
  void drop(float height);
  void jump() { call("moves", "jump", 0); }
  bool fly();
  void walk(bool on);
  void enter(const char* state);
  // Scripts look at the player's moves.
  bool heedsMoves() { return numberOf("heedsMoves") > 0; }
  // The states of a player in the air, without moving it; and the jump key.
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
  // A player that has died where it spawns lives again, away from everything.
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

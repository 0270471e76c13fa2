// A place that runs: its instances in a VM, its scripts started, stepped frame by frame. What
// happens is in observation(). Untrusted scripts: use it in a process that may die (sandbox.h).
#pragma once

#include <functional>
#include <memory>

#include "engine/document.h"
#include "engine/host.h"
#include "engine/observation.h"
#include "engine/report.h"

namespace obby::engine {

class Stage {
 public:
  // Loads the document; nothing runs yet. The document must outlive the stage.
  Stage(const Document& document, const Settings& settings);
  ~Stage();

  // The server's scripts run to their first wait; then the player joins.
  void start();
  // Steps of 1/60 s; fewer if a budget is used up.
  void run(uint32_t frames);
  uint32_t frames() const { return host_->recorder.seen().frames; }
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
  const std::vector<Harm>& harms() { return host_->recorder.seen().harms; }
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
  // What a player can touch or use with effect, as far as listeners tell.
  std::vector<Probe> probes();
  // Parts and what joins or moves them, in the world, that scripts have made.
  std::vector<MadePart> made();
  // Names of the collision groups that there are by now.
  std::vector<std::string> groups();
  // Grows with everything that happens.
  size_t activity() const { return host_->recorder.activity(); }
  // Something waits that did not when restart() was called.
  bool isBusy();
  // Threads that have waited since they began, without those of when restart() was called.
  bool sleeps();
  // Nothing will ever happen by itself.
  bool isIdle();
  // With the player's state as of now.
  const Observation& observation();
  // Forgets what has been seen.
  void forget() { host_->recorder.restart(); }
  // Forgets it, and takes what waits now for what always waits.
  void restart();
  bool isExhausted() const { return host_->vm.isExhausted() || host_->recorder.isFull(); }
  // Instructions that all scripts together may still run.
  uint64_t left() const { return host_->vm.left(); }
  void limit(uint64_t instructions) { host_->vm.limit(instructions); }
  // The script that has used up the memory, if one has.
  InstanceId greedyScript() const { return host_->greedy; }
  // Grows whenever a script begins or ends to run, and by noteWork().
  const unsigned* beat() const { return &host_->beat; }
  // The host does long work between two scripts.
  void noteWork() { ++host_->beat; }

 private:
  void load();
  void loadInstance(InstanceId id);
  void loadReferences(InstanceId id);
  // Calls a function of a file of api/ with `arguments` values from the top of the stack.
  void call(const char* module, const char* name, int arguments, int results = 0);
  double numberOf(const char* name, const char* module = "probe", int arguments = 0);
  // Runs `body` with the stack empty; an error, of used up memory as well, ends it and is noted.
  void read(const char* name, const std::function<void(lua_State*)>& body);
  void note(const std::string& what, const Error& error);
  void readProbes(lua_State* L, std::vector<Probe>& all);
  void readMade(lua_State* L, std::vector<MadePart>& all);

  std::unique_ptr<Host> host_;
  std::vector<int> instances_;       // references in the registry, by id
  double waiting_ = 0, asleep_ = 0;  // threads that waited at the last restart()
};

}  // namespace obby::engine

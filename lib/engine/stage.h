// A place that runs: its instances in a VM, its scripts started, stepped frame by frame. What
// happens is in observation(). Untrusted scripts: use it in a process that may die (sandbox.h).
#pragma once

#include <functional>

#include "engine/document.h"
#include "engine/observation.h"
#include "engine/report.h"
#include "engine/stage_player.h"

namespace obby::engine {

class Stage : public StagePlayer {
 public:
  // Loads the document; nothing runs yet. The document must outlive the stage.
  Stage(const Document& document, const Settings& settings);

  // The server's scripts run to their first wait; then the player joins.
  void start();
  // Steps of 1/60 s; fewer if a budget is used up.
  void run(uint32_t frames);
  uint32_t frames() const { return host_->recorder.seen().frames; }
  const std::vector<Harm>& harms() { return host_->recorder.seen().harms; }
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
  // Runs `body` with the stack empty; an error, of used up memory as well, ends it and is noted.
  void read(const char* name, const std::function<void(lua_State*)>& body);
  void readProbes(lua_State* L, std::vector<Probe>& all);
  void readMade(lua_State* L, std::vector<MadePart>& all);

  std::vector<int> instances_;       // references in the registry, by id
  double waiting_ = 0, asleep_ = 0;  // threads that waited at the last restart()
};

}  // namespace obby::engine

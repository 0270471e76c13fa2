// A running place: its instances in a VM, its scripts started and stepped frame by frame.
// observation() returns what happened. Run untrusted scripts in a process that may die (child.h).
#pragma once

#include <functional>

#include "engine/document.h"
#include "engine/observation.h"
#include "engine/report.h"
#include "engine/stage_player.h"

namespace obby::engine {

class Stage : public StagePlayer {
 public:
  // Loads the document and runs no script. The document must outlive the stage.
  Stage(const Document& document, const Settings& settings);

  // Runs the server's scripts to their first wait, then lets the player join.
  void start();
  // Runs `frames` steps of 1/60 s; fewer if a budget is used up.
  void run(uint32_t frames);
  uint32_t frames() const { return host_->recorder.seen().frames; }
  const std::vector<Harm>& harms() { return host_->recorder.seen().harms; }
  // Returns the probes of all targets whose touch or use may have an effect, judged by their
  // listeners.
  std::vector<Probe> probes();
  // Returns parts, joints and movers in the world that scripts have made.
  std::vector<MadePart> made();
  // Returns the names of all collision groups.
  std::vector<std::string> groups();
  // Returns a count that grows with each recorded event.
  size_t activity() const { return host_->recorder.activity(); }
  // Returns true if something waits that did not wait at restart().
  bool isBusy();
  // Returns true if some thread waits for the first time that did not wait at restart().
  bool sleeps();
  // Returns true if nothing more happens without the player.
  bool isIdle();
  // Returns what has been seen, with the player's current state.
  const Observation& observation();
  // Forgets what has been seen.
  void forget() { host_->recorder.restart(); }
  // Forgets what has been seen, and treats all that waits now as the baseline.
  void restart();
  bool isExhausted() const { return host_->vm.isExhausted() || host_->recorder.isFull(); }
  // Returns the instructions that all scripts together may still run.
  uint64_t left() const { return host_->vm.left(); }
  void limit(uint64_t instructions) { host_->vm.limit(instructions); }
  // Returns the script that has used up the memory; kNoInstance if none has.
  InstanceId greedyScript() const { return host_->greedy; }
  // Returns a counter that grows whenever a script begins or stops running, and by noteWork().
  const unsigned* beat() const { return &host_->beat; }
  // Reports that the host does long work between two scripts.
  void noteWork() { ++host_->beat; }

 private:
  void load();
  void loadInstance(InstanceId id);
  void loadReferences(InstanceId id);
  // Runs `body` with the stack empty. An error, even one of exhausted memory, ends the body and is
  // recorded.
  void read(const char* name, const std::function<void(lua_State*)>& body);
  void readProbes(lua_State* L, std::vector<Probe>& all);
  void readMade(lua_State* L, std::vector<MadePart>& all);

  std::vector<int> instances_;       // references in the registry, by id
  double waiting_ = 0, asleep_ = 0;  // threads that waited at the last restart()
};

}  // namespace obby::engine

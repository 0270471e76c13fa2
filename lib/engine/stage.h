// A place that runs: its instances in a VM, its scripts started, stepped frame by frame. What
// happens is in observation(). Untrusted scripts: use it in a process that may die (sandbox.h).
#pragma once

#include <memory>

#include "engine/document.h"
#include "engine/host.h"
#include "engine/observation.h"

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
  // Puts the player's feet there; yaw in radians, 0 looks along -Z.
  void stand(Vec3 feet, float yaw);
  // Clicks a ClickDetector or a button, holds a ProximityPrompt, activates a tool.
  void use(InstanceId target);
  // With the player's state as of now.
  const Observation& observation();
  // Forgets what has been seen.
  void restart() { host_->recorder.restart(); }
  bool isExhausted() const { return host_->vm.isExhausted() || host_->recorder.isFull(); }
  size_t memoryUsed() const { return host_->vm.memoryUsed(); }

 private:
  void load();
  void loadInstance(InstanceId id);
  void loadReferences(InstanceId id);
  // Calls boot.NAME with `arguments` values from the top of the stack.
  void call(const char* name, int arguments, int results = 0);

  std::unique_ptr<Host> host_;
  std::vector<int> instances_;  // references in the registry, by id
};

}  // namespace obby::engine

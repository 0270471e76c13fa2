// The motions that scripts give to parts and models, before the level has them: two scripts, or two
// threads of one, may move the same part.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "import/roles/role.h"
#include "import/tween_mix.h"

namespace obby::importer {

struct ScriptMotion {
  InstanceId id = kNoInstance;  // a part or a model
  Mat3 rest;                    // its rotation in the file
  Motion motion;
  std::string reason;
  bool guessed = false;
  bool places = true, turns = true;  // whether it sets where the part is, which way it is turned
  std::set<InstanceId> markers;      // parts that show where to go
};

// Adds what the events set of a pose, after which parts, and whether that is sure.
void takeEvents(ScriptMotion& motion, const PoseEvents& events);

bool isMovedByAScript(const PartDraft* part);  // null: no

class ScriptMotions {
 public:
  // The context must outlive it.
  explicit ScriptMotions(RoleContext& context) : context_(context) {}

  // Of two for one part the first counts, unless one goes from place to place while the other turns
  // for ever: then the part does both. What is lost is named.
  void add(ScriptMotion found);
  // Names what stays at its position in the file.
  void leave(InstanceId id, const char* kind, const std::string& why);
  // What mixed tweens do not move: they make no single motion, or one that is too long.
  void leaveMixed(InstanceId id, bool tooLong, const std::string& reason);
  // Gives the level what was added so far.
  void give();

 private:
  RoleContext& context_;
  std::vector<ScriptMotion> waiting_;
  std::map<InstanceId, size_t> known_;  // how many were added before it
  size_t given_ = 0;
  size_t keys_ = 0;  // of those that wait
};

// Adds the motions of what scripts move but once, step by step (pose_steps.h). After the others: of
// two motions of one part the first counts.
void addSteps(RoleContext& context, ScriptMotions& motions);

}  // namespace obby::importer

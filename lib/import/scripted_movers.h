// Which parts scripts move by themselves as the game runs: in endless loops, each frame, by
// tweens, step by step.
#pragma once

#include <map>
#include <set>

#include "import/roles/role.h"

namespace obby::importer {

class ScriptedMovers {
 public:
  // Of all scripts of the context, which must outlive it.
  explicit ScriptedMovers(const RoleContext& context);

  // The scripts that move the part, or a model that it is in. None: it stays where play starts.
  const std::set<InstanceId>& of(InstanceId part);

 private:
  const Tree& tree_;
  std::map<InstanceId, std::set<InstanceId>> targets_;  // parts and models, with their scripts
  std::map<InstanceId, std::set<InstanceId>> known_;    // by part, as far as it was asked
};

}  // namespace obby::importer

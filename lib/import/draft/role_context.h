// The data that the role finders share: the document, the level's parts and the evidence so far.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "import/document/assemblies.h"
#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

// Keys and ticks that motions use; motion_budget.h has the limits.
struct MotionBudget {
  size_t keys = 0, ticks = 0;
};

// The data that the role finders read and write.
class RoleContext {
 public:
  RoleContext(const Tree& tree, const Assemblies& assemblies, LevelDraft& level);

  const Tree& tree;
  const Assemblies& assemblies;
  LevelDraft& level;
  // True if every script of the place ran without an error. Then parts that no script makes deadly
  // are harmless.
  bool scriptsTell = false;
  // Budget spent by parts that a player can meet, and by parts that had no role yet.
  MotionBudget metBudget, unmetBudget;
  std::vector<InstanceId> unmetMoving;  // unmet parts that move
  // Unmet parts beyond the budget, with the reason why they would move.
  std::map<InstanceId, std::string> unmetStill;

  // Returns the draft of a part instance, or null if it is not in the level.
  PartDraft* part(InstanceId id);
  // Returns the drafts of the part itself, or of every level part below a model or folder.
  std::vector<PartDraft*> partsOf(InstanceId id);
  // Returns true if partsOf(id) is not empty, at less cost.
  bool hasParts(InstanceId id);
  // Calls `visit` once for every instance with one of the tags (any case). It passes the first tag
  // that the instance has, as the file writes it.
  void eachTagged(const std::vector<std::string_view>& tags,
                  const std::function<void(InstanceId, const std::string& tag)>& visit) const;
  // Calls `visit` with every marker child that a tower kit may hang below a part or model (value
  // objects and Configurations), and with the instance that it marks.
  void eachMarker(const std::function<void(InstanceId marker, InstanceId owner)>& visit) const;

 private:
  std::unordered_map<InstanceId, size_t> index_;
  std::unordered_map<InstanceId, bool> holders_;  // cache of hasParts, which finders call often
};

// Returns true if some evidence gave the part a role called `role`.
bool hasEvidence(const PartDraft& part, const char* role);

// The evidence that a part does not hurt, by its tag or by a probe. Other roles are unaffected.
constexpr const char* kHarmless = "harmless";

// Returns true if the part has evidence of a role. Evidence about its shape, its joints, script
// changes at the start, and harmlessness does not count.
bool hasRole(const PartDraft& part);

}  // namespace obby::importer

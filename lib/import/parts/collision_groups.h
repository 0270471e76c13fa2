// Finds the parts that players pass through because of their collision groups.
#pragma once

#include <cstdint>
#include <string>

#include "engine/collision_matrix.h"
#include "import/document/observed_place.h"
#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

class CollisionGroups {
 public:
  // Notes a damaged matrix. `scriptsTell` is true if the place's scripts ran without errors, so
  // that their changes to groups are known.
  CollisionGroups(const Tree& tree, const ObservedPlace& place, bool scriptsTell,
                  LevelDraft& level);

  // Makes a part passable if its group does not collide with the players' group. If scripts ran,
  // the document already contains this, with the scripts' changes.
  void apply(PartDraft& part) const;

  // Returns true if it is known whether players collide with the part. It is unknown if nothing
  // lists its group, or if scripts that failed set groups.
  bool isSettled(const Instance& part) const;

 private:
  uint8_t idOf(const Instance& part) const;

  const Tree& tree_;
  engine::GroupMatrix matrix_;
  bool isSaved_ = false;    // the file has a matrix
  bool byScripts_ = false;  // a script mentions collision groups
  bool ran_ = false;
  std::vector<std::string>
      reported_;  // groups that the twin reported, if scripts ran without errors
  bool touchesUseGroups_ = false;
  uint8_t players_ = 0;
};

// Returns why the part is not solid.
Evidence passedEvidence(const Instance& part);

// Returns the group of a part as files store it: a name, or a number in older files. Returns
// "Default" if the part has no group.
std::string groupNameOf(const Instance& part);

}  // namespace obby::importer

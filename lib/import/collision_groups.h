// Collision groups: which parts players pass through because the place says so by groups.
#pragma once

#include <cstdint>
#include <string>

#include "engine/collision_matrix.h"
#include "import/draft.h"
#include "import/observed/place.h"
#include "import/tree.h"

namespace obby::importer {

class CollisionGroups {
 public:
  // Notes a damaged matrix. `scriptsTell`: the place's scripts ran well, so what they do to groups
  // is known.
  CollisionGroups(const Tree& tree, const ObservedPlace& place, bool scriptsTell,
                  LevelDraft& level);

  // Takes the solidity of a part whose group does not collide with the players'. Where scripts ran
  // the document has it already, with what they did.
  void apply(PartDraft& part) const;

  // Whether it is known whether players collide with the part. Else nothing lists its group, or
  // scripts that did not run well set groups.
  bool isSettled(const Instance& part) const;

 private:
  uint8_t idOf(const Instance& part) const;

  const Tree& tree_;
  engine::GroupMatrix matrix_;
  bool isSaved_ = false;    // the file has a matrix
  bool byScripts_ = false;  // a script speaks of collision groups
  bool ran_ = false;
  std::vector<std::string> told_;  // groups of the twin, if the scripts ran well
  bool touchesUseGroups_ = false;
  uint8_t players_ = 0;
};

// Why the part is not solid.
Evidence passedEvidence(const Instance& part);

// The group of a part as files have it: a name, in older ones a number. "Default" for none.
std::string groupNameOf(const Instance& part);

}  // namespace obby::importer

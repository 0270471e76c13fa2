// Collision groups: which parts players pass through because the place says so by groups.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>

#include "base/result.h"
#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

// The matrix that a place saves: names, and a bit for each group that a group collides with.
struct GroupMatrix {
  std::map<std::string, uint8_t, std::less<>> ids;
  std::array<uint32_t, 32> masks;
};

// Fails on damage.
Result<GroupMatrix> decodeGroups(std::string_view blob);

class CollisionGroups {
 public:
  // Notes a damaged matrix.
  CollisionGroups(const Tree& tree, LevelDraft& level);

  // Takes the solidity of a part whose group does not collide with the players'.
  void apply(PartDraft& part) const;

  // Whether it is known whether players collide with the part. Else its group is in no matrix, or
  // scripts set groups.
  bool isSettled(const Instance& part) const;

 private:
  uint8_t idOf(const Instance& part) const;

  const Tree& tree_;
  GroupMatrix matrix_;
  bool isSaved_ = false;    // the file has a matrix
  bool byScripts_ = false;  // a script speaks of collision groups
  bool touchesUseGroups_ = false;
  uint8_t players_ = 0;
};

// The group of a part as files have it: a name, in older ones a number. "Default" for none.
std::string groupNameOf(const Instance& part);

}  // namespace obby::importer

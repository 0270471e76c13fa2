// What the steps that find the start, the order and the end of a level share.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

struct Team {
  int64_t color = 0;
  std::string name;
  bool autoAssigned = true;  // new players may get it
};

struct Course {
  const Tree& tree;
  LevelDraft& level;
  std::vector<Team> teams = {};
  int start = -1;                                   // part index
  std::optional<Vec3> arrived = {};                 // on the start; nullopt: the middle of its top
  std::vector<int> checkpoints = {};                // part indices, in order once that is known
  std::vector<std::pair<Vec3, Vec3>> portals = {};  // from where to where

  PartDraft& part(int index) const { return level.parts[size_t(index)]; }
  const Instance& instance(int index) const { return tree.at(part(index).id); }
  bool is(int index, const char* flag) const;  // a flag of its instance
  const Team* teamOf(int spawn) const;         // that a SpawnLocation is for; null: for all
  // Studs from one part to another: directly, or through the portal that makes it shortest.
  float distance(int from, int to) const;
  // Returns true if a distance is out of all proportion to those between the checkpoints.
  bool isFar(float studs) const;
  void prove(int index, const char* role, std::string reason, bool guessed) const {
    part(index).evidence.push_back({role, std::move(reason), guessed});
  }
};

Course courseOf(const Tree& tree, LevelDraft& level);

// Studs. Pads whose centres are closer are taken for one platform: a default SpawnLocation is 12
// studs wide, so two of them fit side by side.
constexpr float kOnePlatform = 24;

// Finds the start, and which of the other SpawnLocations are checkpoints or the end. `arrived`:
// feet of a new player after scripts ran; nullopt if unknown.
void findStart(Course& course, const std::optional<Vec3>& arrived);
// Puts the checkpoints in order. The first one becomes the start if there is none, or if the start
// is far from the course and no portal leads there.
void orderCheckpoints(Course& course);
// Keeps one goal if none is stated. Without any, the last checkpoint becomes the goal.
void settleGoal(Course& course);

}  // namespace obby::importer

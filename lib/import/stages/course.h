// The data shared by the steps that find the start, the order and the end of a level.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"

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
  int start = -1;                     // part index
  std::optional<Vec3> arrived = {};   // feet on the start; nullopt: the middle of its top
  std::vector<int> checkpoints = {};  // part indices, sorted by orderCheckpoints
  std::vector<std::pair<Vec3, Vec3>> portals = {};  // pairs of entry and exit

  PartDraft& part(int index) const { return level.parts[size_t(index)]; }
  const Instance& instance(int index) const { return tree.at(part(index).id); }
  bool is(int index, const char* flag) const;  // returns a flag of the part's instance
  const Team* teamOf(int spawn) const;         // team of a SpawnLocation; null: open to all
  // Returns the distance between two parts in studs: directly or through one portal, whichever is
  // shorter.
  float distance(int from, int to) const;
  // Returns true if a distance is out of proportion to those between the checkpoints.
  bool isFar(float studs) const;
  void prove(int index, const char* role, std::string reason, bool guessed) const {
    part(index).evidence.push_back({role, std::move(reason), guessed});
  }
};

Course courseOf(const Tree& tree, LevelDraft& level);

// Max studs between the centres of pads that count as one platform. A default SpawnLocation is 12
// studs wide, so two of them fit side by side.
constexpr float kOnePlatform = 24;

// Finds the start, and the other SpawnLocations that are checkpoints or the end. `arrived` is the
// feet of a new player after the scripts ran, or nullopt if unknown.
void findStart(Course& course, const std::optional<Vec3>& arrived);
// Sorts the checkpoints into play order. The first one becomes the start if there is none, or if
// the start is far from the course and no portal leads there.
void orderCheckpoints(Course& course);
// Keeps one goal if none is stated. Without any goal, the last checkpoint becomes the goal.
void settleGoal(Course& course);

}  // namespace obby::importer

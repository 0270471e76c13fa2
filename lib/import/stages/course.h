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
  bool joined = true;  // players get it by themselves
};

struct Course {
  const Tree& tree;
  LevelDraft& level;
  std::vector<Team> teams = {};
  int start = -1;                                   // part index
  std::optional<Vec3> arrived = {};                 // on the start; nothing: the middle of its top
  std::vector<int> checkpoints = {};                // part indices, in order once that is known
  std::vector<std::pair<Vec3, Vec3>> portals = {};  // from where to where

  PartDraft& part(int index) const { return level.parts[size_t(index)]; }
  const Instance& instance(int index) const { return tree.at(part(index).id); }
  bool is(int index, const char* flag) const;  // a flag of its instance
  const Team* teamOf(int spawn) const;         // that a SpawnLocation is for; null: for all
  // Studs from one part to another, by the shortest of all portals or directly.
  float hop(int from, int to) const;
  // Studs of the longest hop from each checkpoint to the next; 0: fewer than two.
  float longestHop() const;
  // Whether a hop is out of all proportion to those between the checkpoints.
  bool isFar(float hop) const;
  void prove(int index, const char* role, std::string reason, bool guessed) const {
    part(index).evidence.push_back({role, std::move(reason), guessed});
  }
};

Course courseOf(const Tree& tree, LevelDraft& level);

// "Winners", "Finish": words for those who have come to the end.
bool isForWinners(std::string_view name);

// The start and, of the other SpawnLocations, those that are checkpoints or the end. `arrived`:
// where the feet of a new player are once scripts have had their way; nothing: not known.
void findStart(Course& course, const std::optional<Vec3>& arrived);
// Puts the checkpoints in order. Without a start the first one serves, and so it does if the start
// is far from the course and no portal leads there.
void orderCheckpoints(Course& course);
// Leaves one goal if none is stated; without any the last checkpoint is it.
void settleGoal(Course& course);

}  // namespace obby::importer

// What the ends of stages are called in titles of queries.
#pragma once

#include <map>
#include <string>

#include "import/draft.h"
#include "import/tree.h"

namespace obby::importer {

class PlaceNames {
 public:
  PlaceNames(const LevelDraft& level, const Tree& tree);

  // The part's name in quotes if it is the only one of those in question and means something, else
  // that of its model or folder, else "checkpoint 2", "the start" or "the goal".
  std::string of(int part) const;

 private:
  const LevelDraft& level_;
  const Tree& tree_;
  std::map<std::string, int> uses_;     // of each name by starts, checkpoints and goals
  std::map<std::string, int> parents_;  // of those above them
};

}  // namespace obby::importer

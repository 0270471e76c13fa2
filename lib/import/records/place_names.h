// Names the ends of stages in titles of queries.
#pragma once

#include <map>
#include <string>

#include "import/document/tree.h"
#include "import/draft/draft.h"

namespace obby::importer {

class PlaceNames {
 public:
  PlaceNames(const LevelDraft& level, const Tree& tree);

  // Returns the part's name in quotes if it is meaningful and unique among the candidates.
  // Otherwise returns "the start" for the start, else the name of the part's model or folder, else
  // "checkpoint 2" or "the goal".
  std::string of(int part) const;

 private:
  const LevelDraft& level_;
  const Tree& tree_;
  std::map<std::string, int> uses_;     // counts of each name among starts, checkpoints and goals
  std::map<std::string, int> parents_;  // counts of the names of their parents
};

}  // namespace obby::importer

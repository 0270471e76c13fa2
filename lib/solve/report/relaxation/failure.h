// What is known of a query that was not solved: where to look for what blocks it.
#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "solve/search/outcome.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

// Where a search has been, to a stud.
class Footprints {
 public:
  // Of further cells of the search: Search::places.
  void note(const std::vector<Vec3>& places);
  std::vector<Vec3> places() const;

 private:
  std::set<std::tuple<int32_t, int32_t, int32_t>> places_;
};

struct Failure {
  const PosedQuery& posed;
  const SearchOutcome& outcome;
  const Footprints& footprints;  // empty where nothing was searched
};

}  // namespace obby::solve

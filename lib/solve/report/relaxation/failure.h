// Results of a query that was not solved. They help to find the parts and limits that block it.
#pragma once

#include <set>
#include <tuple>
#include <vector>

#include "solve/search/outcome.h"
#include "solve/verify/posed_query.h"

namespace obby::solve {

// The places where a search has been, rounded to a stud sideways and a quarter of a stud in height.
class Footprints {
 public:
  // Adds the positions of further cells of the search (Search::places).
  void note(const std::vector<Vec3>& places);
  std::vector<Vec3> places() const;

 private:
  std::set<std::tuple<int32_t, int32_t, int32_t>> places_;
};

struct Failure {
  const PosedQuery& posed;
  const SearchOutcome& outcome;
  const Footprints& footprints;  // empty if there was no search
};

}  // namespace obby::solve

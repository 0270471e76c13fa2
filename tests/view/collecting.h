// Helpers that make collectors and feed them.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "course.h"

namespace obby::view_test {

inline view::Collector strict(const std::vector<std::string>& only = {}) {
  return view::Collector([](const io::Record&, Error error) -> Status { return error; }, only);
}

inline view::Collector withBudget(view::PageBudget budget) {
  return view::Collector([](const io::Record&, Error error) -> Status { return error; }, {},
                         budget);
}

inline void addAll(view::Collector& collector, const std::vector<std::string>& lines) {
  for (const std::string& text : lines) {
    ASSERT_TRUE(collector.add(recordOf(text)));
    ASSERT_TRUE(collector.update());
  }
}

inline std::string progressLine(io::RecordBuilder& best,
                                const std::vector<io::RecordBuilder*>& deaths, float closest) {
  io::RecordBuilder builder;
  auto p = builder.root().initProgress();
  p.setQuery("ahead");
  p.setClosest(closest);
  p.setSteps(1000);
  p.setBest(best.reader().getTrajectory());
  auto list = p.initDeaths(uint32_t(deaths.size()));
  for (uint32_t i = 0; i < list.size(); ++i) {
    list.setWithCaveats(i, deaths[i]->reader().getTrajectory());
  }
  return line(builder);
}

// The record of a search that goes on to improve its first solution.
inline std::string firstSolutionLine(io::RecordBuilder& solution) {
  io::RecordBuilder builder;
  auto p = builder.root().initProgress();
  p.setQuery("ahead");
  p.setSeconds(0.25f);
  p.setSolution(solution.reader().getTrajectory());
  return line(builder);
}

}  // namespace obby::view_test

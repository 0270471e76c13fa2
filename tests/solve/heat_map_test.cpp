// A coarse map of visited places counts every cell, but does not keep its exact position.
#include "solve/search/archive/heat_map.h"

#include <gtest/gtest.h>

#include <cmath>

#include "base/random.h"
#include "io/record.h"
#include "scenes.h"
#include "solve/search/methods/go_explore.h"

namespace obby::solve {
namespace {

std::vector<Vec3> spread(size_t count, float reach) {
  Random random(1, 2);
  std::vector<Vec3> out;
  const auto axis = [&] { return reach * (2 * random.unit() - 1); };
  for (size_t i = 0; i < count; ++i) out.push_back({axis(), axis(), axis()});
  return out;
}

io::RecordBuilder filled(const HeatMap& map) {
  io::RecordBuilder record;
  map.fill(record.root().initResult().initHeatMap());
  return record;
}

uint64_t cellsOf(schema::HeatMap::Reader map) {
  uint64_t sum = 0;
  for (const auto cube : map.getCubes()) sum += cube.getCells();
  return sum;
}

TEST(HeatMap, CountsCellsPerCubeAndKeepsTheLowestFeet) {
  HeatMap map;
  map.note({{0.5f, 3.5f, 0.5f}, {1.5f, 2.25f, 0.5f}, {-0.5f, 2.5f, 0.5f}});
  const auto record = filled(map);
  const auto out = record.reader().getResult().getHeatMap();
  EXPECT_EQ(out.getSize(), 2);
  ASSERT_EQ(out.getCubes().size(), 2u);
  EXPECT_EQ(out.getCubes()[0].getFeet().getX(), -0.5f) << "in order of x";
  EXPECT_EQ(out.getCubes()[1].getCells(), 2u);
  EXPECT_EQ(out.getCubes()[1].getFeet().getY(), 2.25f);
}

TEST(HeatMap, GrowsCoarserAndLosesNoCell) {
  HeatMap map;
  map.note(spread(20000, 100));
  const auto record = filled(map);
  const auto out = record.reader().getResult().getHeatMap();
  EXPECT_LE(out.getCubes().size(), 4096u);
  EXPECT_GT(out.getCubes().size(), 512u) << "no coarser than it has to be";
  EXPECT_EQ(cellsOf(out), 20000u);
  EXPECT_EQ(std::log2(out.getSize()), std::round(std::log2(out.getSize())));
}

// The answer must not depend on how often the search is inspected.
TEST(HeatMap, DoesNotDependOnTheOrderOfUpdates) {
  const std::vector<Vec3> places = spread(20000, 100);
  HeatMap atOnce, bitByBit;
  atOnce.note(places);
  for (const Vec3 place : places) bitByBit.note({place});
  EXPECT_EQ(filled(atOnce).reader().toString().flatten(),
            filled(bitByBit).reader().toString().flatten());
}

TEST(HeatMap, HasEachCellOfASearch) {
  const level::Level level = steppingStones().compile();
  PlainQuery asked(level);
  const Problem problem = asked.problem();
  ThreadPool pool(1);
  GoExplore search(problem, 1, {}, pool);
  HeatMap map;
  uint32_t noted = 0;
  for (int round = 0; round < 5; ++round) {
    search.round();
    const std::vector<Vec3> places = search.places(noted);
    noted += uint32_t(places.size());
    map.note(places);
  }
  const auto record = filled(map);
  EXPECT_EQ(cellsOf(record.reader().getResult().getHeatMap()), search.cellCount());
}

}  // namespace
}  // namespace obby::solve

// Small levels and queries for the solver's tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "io/pipeline.h"
#include "sim/simulator.h"
#include "solve/filter.h"
#include "solve/methods.h"
#include "solve/model/problem.h"
#include "support/level_builder.h"
#include "support/plain_problem.h"

namespace obby::solve {

using support::LevelBuilder;

// Returns three platforms along -Z, one jump apart: from 0 to -8, -12 to -20, and -24 to -32. Their
// tops are at height 0.
inline LevelBuilder steppingStones() {
  LevelBuilder b;
  for (int i = 0; i < 3; ++i) b.block({0, -0.5f, -4 - 12.0f * float(i)}, {8, 1, 8});
  b.spawn({0, 0, -2});
  b.physics([](schema::PhysicsParams::Builder p) { p.setFallenPartsHeight(-40); });
  return b;
}

inline level::TargetView boxAt(Vec3 center, Vec3 size) { return {{{center, {}}, size * 0.5f}}; }

// A query with plain fields, for one level. It has no limits unless a test sets them.
struct PlainQuery {
  explicit PlainQuery(const level::Level& l) : level(l) {
    query.goal = boxAt({0, 2, -28}, {8, 4, 8});
  }
  Problem problem() {
    query.waypoints = waypoints.data();
    query.waypointCount = uint32_t(waypoints.size());
    query.avoid = avoid.data();
    query.avoidCount = uint32_t(avoid.size());
    return support::plainProblem(level, query);
  }
  const level::Level& level;
  level::QueryView query{};
  std::vector<level::WaypointView> waypoints;
  std::vector<level::TargetView> avoid;
};

// The filter's result for a stream of JSON lines.
struct Filtered {
  std::string output;
  Status status;
  FilterCounts counts;
};

inline Filtered runFilter(const std::string& path, FilterOptions options) {
  if (options.solver.method == nullptr) options.solver.method = findMethod("auto");
  Filtered result;
  io::SourceOptions source;
  source.inputs = {path};
  io::Pipeline pipeline(std::move(source), {"test", "0", options.solver.budget.seed},
                        io::StreamWriter::toBytes(io::Format::jsonl, &result.output));
  Filter filter(std::move(options), pipeline);
  result.status = pipeline.run([&](const io::Record& r) { return filter.handle(r); });
  if (result.status) result.status = filter.finishInput();
  const Status finished = pipeline.finish();
  if (result.status) result.status = finished;
  result.counts = filter.counts();
  return result;
}

// A file with these lines, which the destructor removes.
class LinesFile {
 public:
  explicit LinesFile(const std::string& text) : path_(testing::TempDir() + name()) {
    std::FILE* f = std::fopen(path_.c_str(), "w");
    std::fwrite(text.data(), 1, text.size(), f);
    std::fclose(f);
  }
  ~LinesFile() { std::remove(path_.c_str()); }
  LinesFile(const LinesFile&) = delete;
  LinesFile& operator=(const LinesFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  static std::string name() {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    static int count = 0;
    std::string name = std::string("obby-") + info->test_suite_name() + "-" + info->name() + "-" +
                       std::to_string(++count) + ".jsonl";
    // Names of parameterised tests contain slashes.
    std::replace(name.begin(), name.end(), '/', '-');
    return name;
  }
  std::string path_;
};

// Returns the stepping stones as records, with a query to the third stone. `more` holds further
// fields of the query, each after a comma.
inline std::string stonesText(const std::string& more = {}) {
  std::string text =
      R"({"type":"level","name":"stones","physics":{"fallenPartsHeight":-40},"parts":[)"
      R"({"name":"A","position":[0,-0.5,-4],"size":[8,1,8]},)"
      R"({"name":"B","position":[0,-0.5,-16],"size":[8,1,8]},)"
      R"({"name":"C","position":[0,-0.5,-28],"size":[8,1,8],"goal":{}}],)"
      R"("spawns":[{"position":[0,0,-2]}]})";
  return text + "\n" + R"({"type":"query","id":"q","goal":{"position":[0,2,-28],"size":[8,4,8]})" +
         more + "}\n";
}

}  // namespace obby::solve

// A small course with a goal ahead, a drop to the left and a kill part to the right. Also provides
// its records, and trajectories made by the simulator.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/json_codec.h"
#include "io/record.h"
#include "io/stream.h"
#include "sim/simulator.h"
#include "view/report.h"
#include "view/tracks.h"

namespace obby::view_test {

inline const std::string kLevel =
    R"({"type":"level","name":"Course </script><b>","spawns":[{"name":"s","position":[0,0,0]}],"parts":[)"
    R"({"name":"Floor","position":[0,-0.5,-10],"size":[10,1,30]},)"
    R"({"name":"Lava","position":[12,-0.5,-2],"size":[14,1,14],"kill":{}},)"
    R"({"name":"Lift","position":[-20,2,-10],"size":[4,1,4],"motion":{"keys":[{"position":[-20,2,-10]},)"
    R"({"time":1,"position":[-20,8,-10]}],"repeat":"pingPong"}},)"
    R"({"name":"Fan","position":[-30,2,-10],"size":[6,1,1],"motion":{"spin":{"speed":3}}},)"
    R"({"name":"Rock","position":[-24,0,-20],"size":[4,4,4],"shape":"ball","source":{"path":"Workspace/Rock"}}]})";
inline const std::string kQuery =
    R"({"type":"query","id":"ahead","level":"Course </script><b>",)"
    R"("goal":{"name":"Goal","position":[0,2,-20],"size":[8,4,4]},)"
    R"("waypoints":[{"region":{"name":"middle","position":[0,2,-10],"size":[8,4,2]},"maxJumps":1}],)"
    R"("avoid":[{"name":"no","position":[4,2,-22],"size":[1,2,1]}]})";

constexpr uint16_t kAhead = 0, kLeft = 16384, kRight = 49152;

inline std::string headed(const std::vector<std::string>& lines) {
  std::string text =
      R"({"type":"header","schemaMajor":2,"tool":"test","version":"0","floatPolicy":"ieee754-nofma"})"
      "\n";
  for (const std::string& line : lines) text += line + "\n";
  return text + R"({"type":"end","records":")" + std::to_string(lines.size() + 1) + "\"}\n";
}

inline io::Record recordOf(const std::string& line) {
  io::StreamReader reader = io::StreamReader::overBytes(line + "\n", "test");
  auto record = reader.next();
  if (!record) throw std::runtime_error(record.error().text());
  return **record;
}

// Returns a trajectory of `ticks` ticks in one direction, with the simulator's outcome.
inline io::RecordBuilder walk(uint16_t heading, uint32_t ticks, bool jump = false) {
  const io::Record levelRecord = recordOf(kLevel), queryRecord = recordOf(kQuery);
  auto level = level::Level::compile(levelRecord.reader().getLevel());
  if (!level) throw std::runtime_error(level.error().text());
  auto query = level::Query::compile(queryRecord.reader().getQuery(), *level);
  if (!query) throw std::runtime_error(query.error().text());
  io::RecordBuilder builder;
  auto path = builder.root().initTrajectory();
  path.setQuery("ahead");
  path.setLevel("Course </script><b>");
  auto run = path.initActions(1)[0];
  run.setTicks(ticks);
  run.setWalk(true);
  run.setHeading(heading);
  run.setJump(jump);
  auto plan = sim::planFromRecord(path.asReader());
  if (!plan) throw std::runtime_error(plan.error().text());
  const level::QueryView rules = query->view();
  const auto worlds = sim::replay(level->view(), &rules, *plan).worlds;
  const sim::World& last = worlds.back();
  path.setOutcome(schema::Outcome(uint16_t(last.outcome)));
  path.setTicks(uint32_t(worlds.size() - 1));
  path.setJumps(last.jumps);
  path.setPart(last.part == level::kNone ? -1 : int32_t(last.part));
  path.setStateHash(sim::stateHash(last));
  return builder;
}

inline std::string line(io::RecordBuilder& builder) {
  auto text = io::recordToJson(builder.reader());
  if (!text) throw std::runtime_error(text.error().text());
  return *std::move(text);
}

inline std::string resultLine(const std::string& verdict, uint32_t ticks) {
  return R"({"type":"result","query":"ahead","level":"Course </script><b>","verdict":")" + verdict +
         R"(","solutions":1,"ticks":)" + std::to_string(ticks) +
         R"(,"steps":"1234567","reason":"Straight on.","timing":{"firstSolution":0.25}})";
}

// Returns the first error, unless `errors` collects the errors.
inline Result<view::Report> collect(const std::vector<std::string>& lines,
                                    std::vector<Error>* errors = nullptr,
                                    const std::vector<std::string>& only = {}) {
  view::Collector collector(
      [&](const io::Record&, Error error) -> Status {
        if (errors == nullptr) return error;
        errors->push_back(std::move(error));
        return {};
      },
      only);
  for (const std::string& text : lines) OBBY_RETURN_IF_ERROR(collector.add(recordOf(text)));
  OBBY_RETURN_IF_ERROR(collector.update());
  OBBY_RETURN_IF_ERROR(collector.checkChosen());
  return collector.take();
}

inline std::vector<view::Track> tracksOf(const view::LevelEntry& entry, uint32_t ticks,
                                         uint32_t stride) {
  std::vector<view::Track> tracks;
  view::forTracks(entry.level->view(), ticks, stride,
                  [&](const view::Track& track) { tracks.push_back(track); });
  return tracks;
}

// Returns the course with a solution, a fall and a death.
inline view::Report solvedReport() {
  auto ahead = walk(kAhead, 200), left = walk(kLeft, 300), right = walk(kRight, 300, true);
  const uint32_t ticks = ahead.reader().getTrajectory().getTicks();
  auto report =
      collect({kLevel, line(left), line(ahead), line(right), resultLine("solved", ticks), kQuery});
  if (!report) throw std::runtime_error(report.error().text());
  return *std::move(report);
}

}  // namespace obby::view_test

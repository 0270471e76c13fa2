// Writes a query into the page's data: regions, result, trajectories.
#include <string>

#include "level/record_values.h"
#include "view/enum_name.h"
#include "view/page_parts.h"

namespace obby::view {
namespace {

void writeVec(io::JsonWriter& json, Vec3 v) {
  json.open('[').value(v.x).value(v.y).value(v.z).close();
}

void writeVec(io::JsonWriter& json, schema::Vec3::Reader v) {
  writeVec(json, Vec3{v.getX(), v.getY(), v.getZ()});
}

void writeRegion(io::JsonWriter& json, schema::Region::Reader region) {
  json.open('{').field("name", std::string_view(region.getName().cStr()));
  json.key("position");
  writeVec(json, region.getPosition());
  const auto q = region.getRotation();
  json.key("rotation").open('[').value(q.getX()).value(q.getY()).value(q.getZ()).value(q.getW());
  json.close().key("size");
  writeVec(json, region.getSize());
  json.close();
}

void writeRegions(io::JsonWriter& json, capnp::List<schema::Region>::Reader regions) {
  json.open('[');
  for (const auto region : regions) writeRegion(json, region);
  json.close();
}

void writeConstraints(io::JsonWriter& json, const QueryEntry& entry) {
  const bool known = entry.query.has_value();
  const auto query = known ? entry.reader() : schema::Query::Reader();
  json.key("start");
  if (known && query.getStart().hasRegion()) {
    writeRegion(json, query.getStart().getRegion());
  } else {
    json.null();
  }
  json.key("startPosition");
  if (entry.compiled) {
    writeVec(json, entry.compiled->start().feet);
  } else {
    json.null();
  }
  json.field("startTick", query.getStart().getTick()).key("goal");
  if (known && query.hasGoal()) {
    writeRegion(json, query.getGoal());
  } else {
    json.null();
  }
  json.key("goals");
  writeRegions(json, query.getGoals());
  json.key("visits");
  writeRegions(json, query.getVisits());
  json.key("waypoints").open('[');
  for (const auto waypoint : query.getWaypoints()) {
    json.open('{').field("maxJumps", waypoint.getMaxJumps()).key("region");
    writeRegion(json, waypoint.getRegion());
    json.close();
  }
  json.close().key("avoid");
  writeRegions(json, query.getAvoid());
  json.field("maxJumps", query.getMaxJumps()).field("minJumps", query.getMinJumps());
  json.field("timeLimit", query.getTimeLimit()).field("maxDamage", query.getMaxDamage());
  json.key("forbid").open('[');
  for (const auto state : query.getForbid()) json.value(enumName(state));
  json.close();
}

// Writes the cut of a proof: the reachable parts and the smallest step beyond them.
void writeCut(io::JsonWriter& json, schema::Cut::Reader cut) {
  json.key("cut").open('{').key("reached").list(cut.getReached());
  json.field("from", cut.getFrom()).field("to", cut.getTo()).field("rise", cut.getRise());
  json.field("gap", cut.getGap()).field("jumps", cut.getJumps());
  json.field("seconds", cut.getSeconds()).close();
}

// Writes how many cells of the search lie in each cube.
void writeHeatMap(io::JsonWriter& json, schema::HeatMap::Reader map) {
  std::vector<Vec3> feet;
  std::vector<uint32_t> counts;
  for (const auto cube : map.getCubes()) {
    feet.push_back(level::vec(cube.getFeet()));
    counts.push_back(cube.getCells());
  }
  json.key("heatMap").open('{').field("size", map.getSize()).key("feet").packed(feet);
  json.key("counts").packed(counts).close();
}

// Writes an answer's findings other than its verdict: the proof's cut, relaxations, routes, and the
// search's saturation.
void writeFindings(io::JsonWriter& json, schema::Result::Reader result) {
  json.key("relaxations").open('[');
  for (const auto relaxation : result.getRelaxations()) {
    json.open('{').field("text", std::string_view(relaxation.getText().cStr()));
    json.field("part", relaxation.getPart()).field("avoid", relaxation.getAvoid()).close();
  }
  json.close().key("routes").open('[');
  for (const auto route : result.getRoutes()) {
    json.open('{').field("count", std::to_string(route.getCount()));
    json.field("ticks", route.getTicks()).key("route").list(route.getRoute()).close();
  }
  json.close();
  if (result.hasCut()) writeCut(json, result.getCut());
  if (result.hasHeatMap()) writeHeatMap(json, result.getHeatMap());
  if (!result.hasEvidence()) return;
  const auto evidence = result.getEvidence();
  json.key("evidence").open('{').field("saturation", enumName(evidence.getSaturation()));
  json.field("newCellChance", evidence.getNewCellChance()).close();
}

void writeResult(io::JsonWriter& json, const QueryEntry& entry) {
  json.key("result");
  if (!entry.result) {
    json.null();
    return;
  }
  const auto result = entry.answer();
  const auto timing = result.getTiming();
  json.open('{').field("verdict", enumName(result.getVerdict(), "unknown"));
  json.field("holds", result.getHolds());
  json.field("reason", std::string_view(result.getReason().cStr()));
  json.field("solutions", result.getSolutions()).field("ticks", result.getTicks());
  json.field("jumps", result.getJumps()).field("steps", std::to_string(result.getSteps()));
  json.field("cells", std::to_string(result.getCells()));
  json.field("rounds", std::to_string(result.getRounds())).field("closest", result.getClosest());
  json.field("seconds", timing.getSeconds()).field("firstSolution", timing.getFirstSolution());
  json.field("stepsPerSecond", timing.getStepsPerSecond());
  json.field("method", std::string_view(result.getMethod().cStr()));
  json.field("seed", std::to_string(result.getSeed())).key("ends").open('[');
  for (const auto end : result.getEnds()) {
    json.open('{').field("outcome", enumName(end.getOutcome())).field("part", end.getPart());
    json.field("avoid", end.getAvoid()).field("count", std::to_string(end.getCount())).close();
  }
  json.close();
  writeFindings(json, result);
  json.close();
}

// Writes the progress of a search without an answer.
void writeProgress(io::JsonWriter& json, const QueryEntry& entry) {
  if (entry.result || !entry.progress) return;
  const auto progress = entry.progress->reader().getProgress();
  json.key("progress").open('{').field("seconds", progress.getSeconds());
  json.field("steps", std::to_string(progress.getSteps()));
  json.field("cells", std::to_string(progress.getCells()));
  json.field("rounds", std::to_string(progress.getRounds()));
  json.field("closest", progress.getClosest()).field("waypoints", progress.getWaypoints()).close();
}

// Returns every stride-th sample and the last one.
template <class T>
std::vector<T> thinnedTo(const std::vector<T>& all, uint32_t stride) {
  if (stride == 1) return all;
  std::vector<T> out;
  for (size_t i = 0; i < all.size(); i += stride) out.push_back(all[i]);
  if ((all.size() - 1) % stride != 0) out.push_back(all.back());
  return out;
}

// Returns (ticks, bits: 1 walk, 2 jump, heading) for each run of equal actions.
std::vector<uint16_t> runsOf(schema::Trajectory::Reader path) {
  constexpr uint32_t kLongest = 65535;
  std::vector<uint16_t> runs;
  for (const auto run : path.getActions()) {
    const auto bits = uint16_t((run.getWalk() ? 1 : 0) | (run.getJump() ? 2 : 0));
    for (uint32_t left = run.getTicks(); left > 0;) {
      const uint32_t ticks = left < kLongest ? left : kLongest;
      runs.insert(runs.end(), {uint16_t(ticks), bits, run.getHeading()});
      left -= ticks;
    }
  }
  return runs;
}

// Writes how close each step is to failing. What a step does not have is left out.
void writeSteps(io::JsonWriter& json, capnp::List<schema::DifficultyStep>::Reader steps) {
  json.key("steps").open('[');
  for (const auto step : steps) {
    json.open('{').field("startTick", step.getStartTick()).field("ticks", step.getTicks());
    if (step.getJumps() > 0) json.field("window", step.getWindow());
    if (step.getMargin() != 0) json.field("margin", step.getMargin());
    if (step.getClearance() >= 0) json.field("clearance", step.getClearance());
    json.close();
  }
  json.close();
}

// Writes a solution's difficulty, if recorded. The page marks the hardest step.
void writeDifficulty(io::JsonWriter& json, schema::Trajectory::Reader path) {
  const auto difficulty = path.getDifficulty();
  if (difficulty.getHardest() >= difficulty.getSteps().size()) return;
  const auto hardest = difficulty.getSteps()[difficulty.getHardest()];
  json.key("difficulty").open('{').field("band", enumName(difficulty.getBand(), "unknown"));
  json.field("success", difficulty.getSuccess());
  json.field("expectedAttempts", difficulty.getExpectedAttempts());
  json.field("noise", std::string_view(difficulty.getNoise().cStr()));
  writeSteps(json, difficulty.getSteps());
  json.key("hardest").open('{');
  json.field("startTick", hardest.getStartTick()).field("ticks", hardest.getTicks());
  json.field("from", hardest.getFrom()).field("to", hardest.getTo());
  json.field("jumps", hardest.getJumps());
  json.field("band", enumName(hardest.getBand(), "unknown"));
  json.field("window", hardest.getWindow()).close().close();
}

void writeBodies(io::JsonWriter& json, const std::vector<BodyTrack>& tracks) {
  json.key("bodies").open('[');
  for (const BodyTrack& track : tracks) {
    json.open('{').field("part", track.part).key("ticks").packed(track.ticks);
    json.key("position").packed(track.positions).key("rotation").packed(track.rotations).close();
  }
  json.close();
}

}  // namespace

void writePath(io::JsonWriter& json, const PathEntry& path, uint32_t stride) {
  constexpr const char* kKinds[] = {"solution", "attempt", "closest", "newest"};
  const auto record = path.inLevelTicks();
  const Playback& play = path.playback;
  // A replay without its query cannot tell why the trajectory ended, but the record can.
  const bool unfinished = play.outcome == schema::Outcome::RUNNING && play.mismatch.empty();
  json.open('{').field("kind", kKinds[size_t(path.kind)]).field("index", record.getIndex());
  if (path.provisional()) json.field("provisional", true);
  json.field("method", std::string_view(record.getMethod().cStr()));
  if (record.getBody().size() > 0) json.field("body", std::string_view(record.getBody().cStr()));
  if (record.getFrameRate() > 0) json.field("frameRate", uint32_t(record.getFrameRate()));
  json.field("outcome", enumName(unfinished ? record.getOutcome() : play.outcome));
  json.field("part", unfinished ? record.getPart() : play.part).field("ticks", play.ticks());
  json.field("jumps", play.jumps()).field("startTick", record.getStartTick());
  json.field("stride", stride).field("avoid", record.getAvoid());
  json.key("route").list(record.getRoute());
  if (!play.mismatch.empty()) json.field("mismatch", play.mismatch);
  writeDifficulty(json, record);
  json.key("position").packed(thinnedTo(play.feet, stride));
  json.key("yaw").packed(thinnedTo(play.yaw, stride));
  json.key("state").packed(thinnedTo(play.state, stride)).key("runs").packed(runsOf(record));
  json.key("jumpTicks").list(play.jumpTicks).key("events").open('[');
  for (const PartEvent& event : play.events) {
    json.open('[').value(event.tick).value(event.part).value(event.solid ? 1 : 0).close();
  }
  json.close().key("motions").open('[');
  for (const MotionEvent& event : play.motions) {
    json.open('[').value(event.tick).value(event.part).value(event.start).close();
  }
  json.close();
  if (!play.bodies.empty()) writeBodies(json, play.bodies);
  json.close();
}

void writeQueryFacts(io::JsonWriter& json, const QueryEntry& entry) {
  json.field("id", entry.id).field("level", entry.level);
  if (entry.query && entry.reader().getTitle().size() > 0)
    json.field("title", std::string_view(entry.reader().getTitle().cStr()));
  writeConstraints(json, entry);
  writeResult(json, entry);
  writeProgress(json, entry);
}

void writeQuery(io::JsonWriter& json, const QueryEntry& entry, const Budget& budget) {
  json.open('{');
  writeQueryFacts(json, entry);
  json.key("trajectories").open('[');
  uint32_t attempts = 0;
  for (const PathEntry& path : entry.paths) {
    const bool attempt = path.kind == PathKind::attempt;
    if (attempt && attempts++ % budget.attemptsOneOf != 0) continue;
    writePath(json, path, attempt ? budget.attemptStride : 1);
  }
  json.close().close();
}

}  // namespace obby::view

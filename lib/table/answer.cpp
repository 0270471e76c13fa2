// Names start and goal by region, part or spawn, otherwise by coordinates.
#include "table/answer.h"

#include <fmt/format.h>

#include <cmath>

namespace obby::table {
namespace {

// Returns `studs` rounded to tenths, as text without a minus before zero.
std::string coordinate(float studs) {
  const double tenths = std::round(double(studs) * 10) / 10;
  return fmt::format("{}", tenths == 0 ? 0.0 : tenths);
}

std::string placeOf(schema::Region::Reader region) {
  if (region.getName().size() > 0) return region.getName();
  if (region.getPart().size() > 0) return region.getPart();
  const auto at = region.getPosition();
  return fmt::format("({}, {}, {})", coordinate(at.getX()), coordinate(at.getY()),
                     coordinate(at.getZ()));
}

std::string startOf(schema::Query::Reader query, const LevelFacts* level) {
  const auto start = query.getStart();
  if (start.hasRegion()) return placeOf(start.getRegion());
  const auto spawn = size_t(start.getSpawn() < 0 ? 0 : start.getSpawn());
  const bool named = level && spawn < level->spawns.size() && !level->spawns[spawn].empty();
  return named ? level->spawns[spawn] : "start";
}

std::string goalOf(schema::Query::Reader query) {
  const auto goals = query.getGoals();
  const size_t count = goals.size() + (query.hasGoal() ? 1 : 0);
  if (count == 0) return {};
  std::string text = placeOf(query.hasGoal() ? query.getGoal() : goals[0]);
  if (count > 1) text += fmt::format(" or {} more", count - 1);
  return text;
}

std::string spawnName(schema::Level::Reader level, schema::Spawn::Reader spawn) {
  if (spawn.getName().size() > 0) return spawn.getName();
  const int32_t part = spawn.getPart();
  if (part < 0 || uint32_t(part) >= level.getParts().size()) return {};
  return level.getParts()[uint32_t(part)].getName();
}

// Returns "'Pad 2' to 'Pad 3'" for "Stage 3: 'Pad 2' to 'Pad 3'": the id says which stage it is.
std::string routeOf(const std::string& title) {
  const size_t colon = title.find(": ");
  return colon == std::string::npos ? title : title.substr(colon + 2);
}

State stateOf(schema::Verdict verdict) {
  switch (verdict) {
    case schema::Verdict::SOLVED: return State::solved;
    case schema::Verdict::UNREACHABLE: return State::unreachable;
    default: return State::unknown;
  }
}

}  // namespace

LevelFacts factsOf(schema::Level::Reader level) {
  LevelFacts facts;
  facts.name = level.getName();
  facts.controlRate = level.getPhysics().getControlRate();
  for (const auto spawn : level.getSpawns()) facts.spawns.push_back(spawnName(level, spawn));
  return facts;
}

void describe(schema::Query::Reader query, const LevelFacts* level, Answer& answer) {
  answer.from = startOf(query, level);
  answer.to = goalOf(query);
  answer.route = routeOf(query.getTitle());
}

void describe(schema::Result::Reader result, double controlRate, Answer& answer) {
  const State verdict = stateOf(result.getVerdict());
  const bool solved = verdict == State::solved;
  answer.state = solved && !result.getHolds() ? State::doubtful : verdict;
  answer.reason = result.getReason();
  answer.playTime.reset();
  answer.foundIn.reset();
  answer.jumps.reset();
  if (!solved) return;
  answer.playTime = result.getTicks() / controlRate;
  answer.jumps = result.getJumps();
  const float found = result.getTiming().getFirstSolution();
  if (found > 0) answer.foundIn = found;
}

}  // namespace obby::table

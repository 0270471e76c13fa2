#include "solve/players/same_keys.h"

#include <algorithm>

#include "solve/model/retimed.h"
#include "solve/search/rollouts/action_runs.h"

namespace obby::solve {

namespace {

// Replays a plan, and returns its trajectory as a search would.
Trajectory played(const PosedQuery& posed, const ActionRuns& keys) {
  const auto& view = posed.level.view();
  const level::QueryView query = posed.query.view();
  const level::StartPose& start = posed.query.start();
  Trajectory p;
  const auto note = [&](const sim::Moment& now) {
    if (now.tick % kPathStep == 0) p.path.push_back(now.world.position);
    if (now.world.jumps > now.before.jumps) p.jumpTicks.push_back(now.tick);
    return true;
  };
  sim::ReplayEnd end =
      sim::replay(view, &query, {start, turnsFromRadians(start.yaw), keys, query.tricks}, note);
  p.ticks = end.ticks;
  p.end = end.world;
  p.endBodies = std::move(end.bodies);
  uint32_t left = end.ticks;
  for (const sim::ActionRun& run : keys) {
    if (left == 0) break;
    p.actions.push_back({run.action, std::min(run.ticks, left)});
    left -= p.actions.back().ticks;
  }
  return p;
}

}  // namespace

size_t slowest(const std::vector<PlayerCase>& cases) {
  return size_t(std::ranges::min_element(cases, {}, &PlayerCase::rate) - cases.begin());
}

std::vector<ActionRuns> firstKeys(std::span<const PlayerCase> cases, uint32_t rate) {
  std::vector<ActionRuns> keys;
  for (const PlayerCase& c : cases) {
    if (c.solutions.empty()) continue;
    const auto plan = sim::planFromRecord(c.solutions.front().reader().getTrajectory());
    if (plan) keys.push_back(retimed(plan->actions, c.rate, rate));
  }
  return keys;
}

Result<KeyPlayer> KeyPlayer::make(const PlayerCase& c) {
  OBBY_ASSIGN(level::Query query, level::Query::compile(c.queryRecord(), c.level->level));
  return KeyPlayer(c, std::move(query));
}

Companion KeyPlayer::companion() const {
  Problem problem = problemOf(posed());
  return {problem.level, problem.query, problem.start, std::move(problem.startBodies)};
}

PosedQuery KeyPlayer::posed() const {
  return {case_->level->level, case_->level->record.reader().getLevel(), query_,
          case_->queryRecord()};
}

std::optional<Trajectory> KeyPlayer::solve(const ActionRuns& keys, uint32_t rate) const {
  if (keys.empty()) return std::nullopt;
  ActionRuns own = retimed(keys, rate, case_->rate);
  own.push_back({keys.back().action, case_->rate});
  Trajectory p = played(posed(), own);
  if (!solves(p, posed())) return std::nullopt;
  return p;
}

}  // namespace obby::solve

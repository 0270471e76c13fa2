// The state of answering a query for several players, and the search for one of them.
#pragma once

#include <algorithm>
#include <vector>

#include "base/stopwatch.h"
#include "solve/players/player_case.h"

namespace obby::solve {

class PlayersRun {
 public:
  // All must outlive the run.
  PlayersRun(const LoadedLevel& level, const SolverOptions& options, const Machine& machine,
             const SolverOutput& output, std::vector<PlayerCase> playerCases)
      : cases(std::move(playerCases)),
        options_(options),
        machine_(machine),
        output_(output),
        rate_(level.level.view().params.controlRate) {}

  std::vector<PlayerCase> cases;

  // Solves one case. Writes progress at once and keeps the other records with the case.
  Status solve(PlayerCase& c, const SolverOptions& options, const PlayerQuestion& asked);

  PlayerQuestion question(const PlayerCase& c) const {
    return {*c.level, c.queryRecord(), c.player, rate_};
  }
  const SolverOptions& options() const { return options_; }
  const SolverOutput& output() const { return output_; }
  uint16_t rate() const { return rate_; }  // ticks per second of the level
  bool interrupted() const {
    return options_.budget.stop != nullptr && options_.budget.stop->load();
  }
  double secondsLeft() const { return std::max(0.0, options_.budget.seconds - watch_.seconds()); }
  uint64_t stepsLeft() const {
    return options_.budget.maxSteps - std::min(steps_, options_.budget.maxSteps);
  }

 private:
  const SolverOptions& options_;
  const Machine& machine_;
  const SolverOutput& output_;
  const uint16_t rate_;
  const Stopwatch watch_;
  uint64_t steps_ = 0;
};

}  // namespace obby::solve

#include "solve/search/rollouts/explore_setup.h"

#include <algorithm>

#include "solve/search/archive/binning.h"
#include "solve/search/rollouts/fatal_fall.h"

namespace obby::solve {

namespace {

constexpr float kClockReach = 10;  // studs around moving parts where the clock matters

RolloutRules makeRules(const Problem& problem, uint64_t seed, const GoExploreSettings& s,
                       const Surfaces& surfaces, const ClockMap& clock,
                       const policy::PilotView& pilot) {
  const Params& params = problem.level.params;
  const JumpReach reach = jumpReach(params);
  const uint32_t ticks = std::max(s.minPhase, uint32_t(s.phaseJumps * reach.airTicks));
  return {{problem.level, problem.query, surfaces.view(), reach, s.explore,
           limitsJumps(problem.query), fatalHeight(problem), pilot},
          makeBinning(problem, s.cellWidth, clock),
          {s.groundedOnly,
           std::max(uint32_t(reach.airTicks), params.controlRate / 2u) * params.substeps,
           std::clamp(s.lookEvery, 1u, ticks)},
          seed,
          ticks};
}

}  // namespace

ExploreSetup::ExploreSetup(const Problem& problem, uint64_t seed, const GoExploreSettings& settings)
    : surfaces_(problem.level),
      clock_(problem.level, kClockReach),
      pilot_(!settings.byPolicy || problem.policy == nullptr
                 ? nullptr
                 : std::make_unique<const policy::Pilot>(problem.level, *problem.policy)),
      rules(makeRules(problem, seed, settings, surfaces_, clock_,
                      pilot_ ? pilot_->view() : policy::PilotView())),
      potential(problem),
      beam(problem) {}

}  // namespace obby::solve

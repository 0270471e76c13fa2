#include "solve/search/methods/ablations.h"

#include "solve/search/methods/go_explore_method.h"
#include "solve/search/selectors/beam_selector.h"
#include "solve/search/selectors/mixed_selector.h"
#include "solve/search/selectors/policy_selector.h"

namespace obby::solve {

namespace {

// Returns the guided settings with one member replaced.
template <auto member, auto value>
GoExploreSettings with() {
  GoExploreSettings s = guidedSettings();
  s.*member = value;
  return s;
}

GoExploreSettings nothingAimed() {
  GoExploreSettings s = guidedSettings();
  s.explore.aimShare = 0;
  return s;
}

GoExploreSettings noRegionAimed() {
  GoExploreSettings s = guidedSettings();
  s.explore.regionShare = 0;
  return s;
}

GoExploreSettings narrowCells() {
  GoExploreSettings s = guidedSettings();
  s.cellWidth = 1;
  return s;
}

GoExploreSettings shortRollouts() {
  GoExploreSettings s = guidedSettings();
  s.phaseJumps = 0;
  return s;
}

GoExploreSettings lockStep() {
  GoExploreSettings s = guidedSettings();
  s.rollouts = s.maxRollouts = 8192;
  return s;
}

std::unique_ptr<Selector> selectorAlone(const Problem& problem, const ExploreContext& context) {
  return policyFirst(hedgedSelector(problem, context), context, kPolicyFrom);
}

std::unique_ptr<Selector> mixedWithoutHedge(const Problem& problem, const ExploreContext& context) {
  return std::make_unique<MixedSelector>(
      policyFirst(plainSelector(problem, context), context, kPolicyFrom),
      makeBeamSelector(problem, context));
}

using Settings = GoExploreSettings;

}  // namespace

const std::vector<Method>& ablations() {
  static const std::vector<Method> table = {
      {"auto-aims", "auto with random actions only", runGoExplore<nothingAimed, makeMixedSelector>},
      {"auto-regions", "auto without moves aimed at the next region",
       runGoExplore<noRegionAimed, makeMixedSelector>},
      {"auto-grounded", "auto, but it also keeps states in the air",
       runGoExplore<with<&Settings::groundedOnly, false>, makeMixedSelector>},
      {"auto-cohorts", "auto with rounds of 8,192 rollouts in lockstep",
       runGoExplore<lockStep, makeMixedSelector>},
      {"auto-phase", "auto with rollouts of 40 ticks",
       runGoExplore<shortRollouts, makeMixedSelector>},
      {"auto-width", "auto with cells of 1 stud", runGoExplore<narrowCells, makeMixedSelector>},
      {"auto-looks", "auto, but it examines every tick",
       runGoExplore<with<&Settings::lookEvery, 1u>, makeMixedSelector>},
      {"auto-beam", "auto with the cell selector alone",
       runGoExplore<guidedSettings, selectorAlone>},
      {"auto-selector", "auto with the beam alone", runGoExplore<aimedSettings, makeBeamSelector>},
      {"auto-hedge", "auto without a lower bound on the cell selector's bias",
       runGoExplore<guidedSettings, mixedWithoutHedge>},
      {"auto-policy", "auto without a policy", runGoExplore<aimedSettings, makeMixedSelector>},
  };
  return table;
}

}  // namespace obby::solve

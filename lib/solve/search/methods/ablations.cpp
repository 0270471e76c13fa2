#include "solve/search/methods/ablations.h"

#include "solve/search/methods/go_explore_method.h"
#include "solve/search/selectors/choose_beam.h"
#include "solve/search/selectors/choose_mixed.h"
#include "solve/search/selectors/choose_policy.h"

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
  s.rollouts = s.mostRollouts = 8192;
  return s;
}

std::unique_ptr<Chooser> selectorAlone(const Problem& problem, const ExploreContext& context) {
  return policyFirst(hedgedSelector(problem, context), context, kPolicyFrom);
}

std::unique_ptr<Chooser> mixedWithoutHedge(const Problem& problem, const ExploreContext& context) {
  return std::make_unique<MixedChooser>(
      policyFirst(plainSelector(problem, context), context, kPolicyFrom),
      makeBeamChooser(problem, context));
}

using Settings = GoExploreSettings;

}  // namespace

const std::vector<Method>& ablations() {
  static const std::vector<Method> table = {
      {"auto-aims", "auto with random actions only", runGoExplore<nothingAimed, makeMixedChooser>},
      {"auto-regions", "auto without moves aimed at the next region",
       runGoExplore<noRegionAimed, makeMixedChooser>},
      {"auto-grounded", "auto that also keeps states in the air",
       runGoExplore<with<&Settings::groundedOnly, false>, makeMixedChooser>},
      {"auto-cohorts", "auto with rounds of 8,192 rollouts in lockstep",
       runGoExplore<lockStep, makeMixedChooser>},
      {"auto-phase", "auto with rollouts of 40 ticks",
       runGoExplore<shortRollouts, makeMixedChooser>},
      {"auto-width", "auto with cells of 1 stud", runGoExplore<narrowCells, makeMixedChooser>},
      {"auto-looks", "auto that examines every tick",
       runGoExplore<with<&Settings::lookEvery, 1u>, makeMixedChooser>},
      {"auto-beam", "auto with the selector alone", runGoExplore<guidedSettings, selectorAlone>},
      {"auto-selector", "auto with the beam alone", runGoExplore<aimedSettings, makeBeamChooser>},
      {"auto-hedge", "auto without the selector's hedge",
       runGoExplore<guidedSettings, mixedWithoutHedge>},
      {"auto-policy", "auto without a policy", runGoExplore<aimedSettings, makeMixedChooser>},
  };
  return table;
}

}  // namespace obby::solve

#include "quality/ompl_planner.h"

#include <ompl/base/goals/GoalSampleableRegion.h>
#include <ompl/base/objectives/PathLengthOptimizationObjective.h>
#include <ompl/control/PathControl.h>
#include <ompl/control/SpaceInformation.h>
#include <ompl/control/planners/sst/SST.h>
#include <ompl/util/Console.h>

#include <cmath>

#include "base/stopwatch.h"
#include "quality/ompl_space.h"
#include "sim/next_region.h"
#include "sim/simulator.h"

namespace obby::bench {

namespace ob = ompl::base;
namespace oc = ompl::control;

// Not anonymous, since SstPlanner::Parts has them as members.
namespace sst {

// Advances the simulator by a tick for each step.
class TickPropagator : public oc::StatePropagator {
 public:
  TickPropagator(oc::SpaceInformation* si, const solve::Problem& problem, Seen& seen)
      : StatePropagator(si), problem_(problem), seen_(seen) {}

  void propagate(const ob::State* state, const oc::Control* control, double duration,
                 ob::State* result) const override {
    Play& play = playOf(result);
    if (result != state) play = playOf(state);
    for (long left = std::lround(duration); left > 0; --left) {
      sim::advance(play.world, play.bodies.data(), problem_.level, &problem_.query,
                   actionOf(control));
      seen_.note(play.world, play.bodies);
    }
  }
  bool canPropagateBackward() const override { return false; }

 private:
  const solve::Problem& problem_;
  Seen& seen_;
};

class AliveChecker : public ob::StateValidityChecker {
 public:
  using StateValidityChecker::StateValidityChecker;
  bool isValid(const ob::State* state) const override {
    const sim::Outcome outcome = playOf(state).world.outcome;
    return outcome == sim::Outcome::running || outcome == sim::Outcome::goal;
  }
};

// The simulator knows all constraints of the query, so the goal is its outcome.
class PlayGoal : public ob::GoalSampleableRegion {
 public:
  PlayGoal(const ob::SpaceInformationPtr& si, const solve::Problem& problem, const PlaySpace& space)
      : GoalSampleableRegion(si), problem_(problem), space_(space) {
    setThreshold(0.5);  // must be above the distance at the goal
  }

  // Returns 0 at the goal, else the studs to the next region, or more if others follow.
  double distanceGoal(const ob::State* state) const override {
    constexpr double kTarget = 1e5;
    const sim::World& world = playOf(state).world;
    if (world.outcome == sim::Outcome::goal) {
      if (firstSeconds_ == 0) firstSeconds_ = watch_.seconds();
      return 0;
    }
    const level::QueryView& q = problem_.query;
    const uint32_t left = q.waypointCount + q.visitCount - sim::targetsReached(world);
    return 1 + kTarget * left + double(sim::nextRegion(q, world).distance);
  }
  void sampleGoal(ob::State* state) const override { space_.sampleNext(playOf(state)); }
  unsigned int maxSampleCount() const override { return 1u << 30; }

  double firstSeconds() const { return firstSeconds_; }
  double seconds() const { return watch_.seconds(); }

 private:
  const solve::Problem& problem_;
  const PlaySpace& space_;
  const Stopwatch watch_;
  mutable double firstSeconds_ = 0;
};

// Ticks of play. A goal reached within a step counts from the tick at which it was reached.
class TimeObjective : public ob::OptimizationObjective {
 public:
  using OptimizationObjective::OptimizationObjective;
  ob::Cost stateCost(const ob::State*) const override { return ob::Cost(0); }
  ob::Cost motionCost(const ob::State* from, const ob::State* to) const override {
    return ob::Cost(double(playOf(to).world.tick - playOf(from).world.tick));
  }
};

class SeededSst : public oc::SST {
 public:
  SeededSst(const oc::SpaceInformationPtr& si, uint64_t seed) : SST(si) {
    rng_.setLocalSeed(uint32_t(seed));
  }
};

oc::SpaceInformationPtr spaceInformation(const solve::Problem& problem, Seen& seen,
                                         const std::shared_ptr<PlaySpace>& space,
                                         const SstSettings& settings, uint64_t seed) {
  const bool mayJump = sim::jumpsLeft(problem.query, problem.start) > 0;
  auto keys = std::make_shared<KeysSpace>(space, mayJump, seed);
  auto si = std::make_shared<oc::SpaceInformation>(space, keys);
  si->setStateValidityChecker(std::make_shared<AliveChecker>(si.get()));
  si->setStatePropagator(std::make_shared<TickPropagator>(si.get(), problem, seen));
  si->setPropagationStepSize(1);
  si->setMinMaxControlDuration(settings.minTicks, settings.maxTicks);
  si->setup();
  return si;
}

}  // namespace sst

struct SstPlanner::Parts {
  Parts(const solve::Problem& problem, const SstSettings& settings, uint64_t seed)
      : seen(problem),
        space(std::make_shared<PlaySpace>(problem, seen, seed)),
        si(sst::spaceInformation(problem, seen, space, settings, seed)),
        goal(std::make_shared<sst::PlayGoal>(si, problem, *space)),
        definition(std::make_shared<ob::ProblemDefinition>(si)),
        planner(std::make_shared<sst::SeededSst>(si, seed)) {
    ob::ScopedState<> start(space);
    playOf(start.get()).world = problem.start;
    playOf(start.get()).bodies = problem.startBodies;
    definition->addStartState(start);
    definition->setGoal(goal);
    definition->setOptimizationObjective(std::make_shared<sst::TimeObjective>(si));
    planner->setProblemDefinition(definition);
    planner->setSelectionRadius(settings.selectionRadius);
    planner->setPruningRadius(settings.pruningRadius);
    planner->setGoalBias(settings.goalBias);
    planner->setup();
  }

  Seen seen;
  std::shared_ptr<PlaySpace> space;
  oc::SpaceInformationPtr si;
  std::shared_ptr<sst::PlayGoal> goal;
  ob::ProblemDefinitionPtr definition;
  std::shared_ptr<sst::SeededSst> planner;
  std::optional<solve::ActionRuns> best;
};

SstPlanner::SstPlanner(const solve::Problem& problem, const SstSettings& settings, uint64_t seed) {
  ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
  // For the random numbers inside OMPL that no object of ours seeds.
  [[maybe_unused]] static const bool kSeeded = (ompl::RNG::setSeed(1), true);
  parts_ = std::make_unique<Parts>(problem, settings, seed);
}

SstPlanner::~SstPlanner() = default;

std::optional<solve::ActionRuns> SstPlanner::run(uint64_t ticks) {
  const ob::PlannerTerminationCondition spent([&] { return parts_->seen.ticks >= ticks; });
  ob::ProblemDefinition& definition = *parts_->definition;
  definition.clearSolutionPaths();
  parts_->planner->solve(spent);
  if (!definition.hasExactSolution()) return parts_->best;  // no faster one in this call
  const auto& path = *definition.getSolutionPath()->as<oc::PathControl>();
  parts_->best.emplace();
  for (unsigned i = 0; i < path.getControlCount(); ++i) {
    const auto held = uint32_t(std::lround(path.getControlDuration(i)));
    parts_->best->push_back({actionOf(path.getControl(i)), held});
  }
  return parts_->best;
}

double SstPlanner::firstSeconds() const { return parts_->goal->firstSeconds(); }
double SstPlanner::seconds() const { return parts_->goal->seconds(); }

}  // namespace obby::bench

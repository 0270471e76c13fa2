#include "solve/verify/posed_query.h"

#include "io/record.h"
#include "sim/simulator.h"
#include "solve/model/trajectory_record.h"
#include "solve/verify/verifier.h"

namespace obby::solve {

Problem problemOf(const PosedQuery& posed) {
  level::LevelView view = posed.level.view();
  view.params.tricks = posed.query.view().tricks;
  view.params.directionStep = posed.query.view().directionStep;
  view.params.directionFrom = turnsFromRadians(posed.query.start().yaw);
  return {view,
          posed.query.view(),
          sim::makeWorld(view, posed.query.start()),
          sim::startBodies(view),
          posed.level.bounds(),
          posed.level.hasMotion(),
          {},
          posed.policy};
}

bool solves(const Trajectory& trajectory, const PosedQuery& posed) {
  if (trajectory.end.outcome != sim::Outcome::goal) return false;
  io::RecordBuilder record;
  const AnswerIdentity identity{
      posed.query.id(), posed.level.name(), posed.query.start(), {}, posed.query.view().tricks, {}};
  fillTrajectory(record.root().initTrajectory(), identity, trajectory, 0);
  return bool(
      verify(posed.level, posed.levelRecord, posed.queryRecord, record.reader().getTrajectory()));
}

}  // namespace obby::solve

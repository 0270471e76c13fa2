#include "solve/model/trajectory_record.h"

#include "level/record_values.h"
#include "level/tricks.h"
#include "sim/simulator.h"

namespace obby::solve {

void fillTrajectory(schema::Trajectory::Builder record, const AnswerIdentity& identity,
                    const Trajectory& trajectory, uint32_t index) {
  const sim::World& end = trajectory.end;
  record.setQuery(identity.query);
  record.setLevel(identity.level);
  record.setMethod(identity.method);
  record.setBody(identity.player.body);
  record.setFrameRate(identity.player.frameRate);
  record.setIndex(index);
  record.setOutcome(schema::Outcome(end.outcome));
  sim::writePlan(
      {identity.start, turnsFromRadians(identity.start.yaw), trajectory.actions, identity.tricks},
      record);
  record.setTicks(trajectory.ticks);
  record.setJumps(end.jumps);
  record.setWaypoints(end.waypoints);
  record.setVisited(end.visited);
  fillBlame(record, end.outcome, end.part);
  record.setStateHash(sim::stateHash(end, trajectory.endBodies));
  level::set(record.initEndPosition(), end.position);
}

void fillPath(schema::Trajectory::Builder record, const Trajectory& trajectory) {
  auto path = record.initPath();
  path.setStep(kPathStep);
  path.setTicks(trajectory.ticks);
  std::vector<Vec3> feet = trajectory.path;
  if (trajectory.ticks % kPathStep != 0) feet.push_back(trajectory.end.position);
  auto points = path.initPoints(uint32_t(feet.size()));
  for (uint32_t i = 0; i < points.size(); ++i) level::set(points[i], feet[i]);
  auto ticks = path.initJumpTicks(uint32_t(trajectory.jumpTicks.size()));
  for (uint32_t i = 0; i < ticks.size(); ++i) ticks.set(i, trajectory.jumpTicks[i]);
}

}  // namespace obby::solve

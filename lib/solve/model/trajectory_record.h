// Writes trajectories into records of the stream.
#pragma once

#include <string>
#include <vector>

#include "level/level.h"
#include "level/player.h"
#include "schema/obby.capnp.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

// The fields that all records of one answer share.
struct AnswerIdentity {
  std::string query;
  std::string level;
  level::StartPose start;
  std::string method;         // name in the table of methods
  uint16_t tricks = 0;        // Params::tricks of the query
  level::Player player = {};  // player of the trajectories
};

void fillTrajectory(schema::Trajectory::Builder record, const AnswerIdentity& identity,
                    const Trajectory& trajectory, uint32_t index);

// Fills in the path, for readers that cannot replay the actions.
void fillPath(schema::Trajectory::Builder record, const Trajectory& trajectory);

// Fills in the parts of a route, in order. `Record` builds a Trajectory or a RouteCount.
template <class Record>
void fillRoute(Record record, const std::vector<int32_t>& route) {
  auto parts = record.initRoute(uint32_t(route.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) parts.set(i, route[i]);
}

// World::part indexes the avoid list if the outcome is `avoided`, and the level's parts otherwise.
template <class Record>
void fillBlame(Record record, sim::Outcome outcome, uint32_t part) {
  if (part == level::kNone) return;
  if (outcome == sim::Outcome::avoided) {
    record.setAvoid(int32_t(part));
  } else {
    record.setPart(int32_t(part));
  }
}

}  // namespace obby::solve

// A playthrough as a record of the stream.
#pragma once

#include <string>
#include <vector>

#include "level/level.h"
#include "level/player.h"
#include "schema/obby.capnp.h"
#include "solve/model/playthrough.h"

namespace obby::solve {

// What every record of one answer names.
struct AnswerIdentity {
  std::string query;
  std::string level;
  level::StartPose start;
  std::string method;         // name of its row
  uint16_t tricks = 0;        // Params::tricks of the query
  level::Player player = {};  // of its trajectories
};

void fillTrajectory(schema::Trajectory::Builder record, const AnswerIdentity& identity,
                    const Playthrough& playthrough, uint32_t index);

// For readers that cannot replay the actions.
void fillPath(schema::Trajectory::Builder record, const Playthrough& playthrough);

// The parts of a route, in order; of a Trajectory or a RouteCount.
template <class Record>
void fillRoute(Record record, const std::vector<int32_t>& route) {
  auto parts = record.initRoute(uint32_t(route.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) parts.set(i, route[i]);
}

// World::part is an index into one of two lists.
template <class Record>
void fillBlame(Record record, sim::Outcome outcome, uint32_t part) {
  if (part == kNone) return;
  if (outcome == sim::Outcome::avoided) {
    record.setAvoid(int32_t(part));
  } else {
    record.setPart(int32_t(part));
  }
}

}  // namespace obby::solve

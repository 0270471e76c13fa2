// What the search found, as records of the stream.
#pragma once

#include <string>

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/methods.h"
#include "solve/relaxation/explain.h"

namespace obby::solve {

// What every record of one answer names.
struct AnswerIdentity {
  std::string query;
  std::string level;
  level::StartPose start;
  std::string method;   // name of its row
  uint16_t tricks = 0;  // Params::tricks of the query
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

// `paths`: with the path of each trajectory.
void fillProgress(schema::Progress::Builder record, const AnswerIdentity& identity,
                  const SearchView& view, bool paths);

schema::Verdict verdictOf(const SearchOutcome& outcome);

// Everything but timing.compile, seed and heatMap, which the caller knows.
void fillResult(schema::Result::Builder record, const AnswerIdentity& identity,
                const SearchOutcome& outcome, const level::Level& level,
                schema::Level::Reader levelRecord, schema::Query::Reader query);

// What was found to help, also as the end of the record's reason.
void fillRelaxations(schema::Result::Builder record, const std::vector<Relaxation>& found);

}  // namespace obby::solve

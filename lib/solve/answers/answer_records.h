// Writes the results of a search into records of the stream.
#pragma once

#include <string>

#include "level/level.h"
#include "level/player.h"
#include "schema/obby.capnp.h"
#include "solve/methods.h"
#include "solve/relaxation/explain.h"

namespace obby::solve {

// The fields that all records of one answer share.
struct AnswerIdentity {
  std::string query;
  std::string level;
  level::StartPose start;
  std::string method;         // name in the table of methods
  uint16_t tricks = 0;        // Params::tricks of the query
  level::Player player = {};  // player of its trajectories
};

void fillTrajectory(schema::Trajectory::Builder record, const AnswerIdentity& identity,
                    const Playthrough& playthrough, uint32_t index);

// Fills in the path, for readers that cannot replay the actions.
void fillPath(schema::Trajectory::Builder record, const Playthrough& playthrough);

// Fills in the parts of a route, in order. `Record` builds a Trajectory or a RouteCount.
template <class Record>
void fillRoute(Record record, const std::vector<int32_t>& route) {
  auto parts = record.initRoute(uint32_t(route.size()));
  for (uint32_t i = 0; i < parts.size(); ++i) parts.set(i, route[i]);
}

// `paths`: fills in the path of each trajectory, too.
void fillProgress(schema::Progress::Builder record, const AnswerIdentity& identity,
                  const SearchView& view, bool paths);

schema::Verdict verdictOf(const SearchOutcome& outcome);

// Fills in everything but timing.compile, seed and heatMap, which the caller knows.
void fillResult(schema::Result::Builder record, const AnswerIdentity& identity,
                const SearchOutcome& outcome, const level::Level& level,
                schema::Level::Reader levelRecord, schema::Query::Reader query);

// Fills in the relaxations that help. The reason ends with the first, or says that none helps.
void fillRelaxations(schema::Result::Builder record, const std::vector<Relaxation>& found);

}  // namespace obby::solve

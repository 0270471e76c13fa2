// Writes the results of a search into records of the stream.
#pragma once

#include <string>

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/model/trajectory_record.h"
#include "solve/search/outcome.h"

namespace obby::solve {

// `paths`: fills in the path of each trajectory, too.
void fillProgress(schema::Progress::Builder record, const AnswerIdentity& identity,
                  const SearchView& view, bool paths);

// Fills in the solution that was found first, and the seconds until then.
void fillFirstSolution(schema::Progress::Builder record, const AnswerIdentity& identity,
                       const Trajectory& solution, double seconds, bool paths);

schema::Verdict verdictOf(const SearchOutcome& outcome);

// Fills in everything but timing.compile, seed and heatMap, which the caller knows.
void fillResult(schema::Result::Builder record, const AnswerIdentity& identity,
                const SearchOutcome& outcome, const level::Level& level,
                schema::Level::Reader levelRecord, schema::Query::Reader query);

}  // namespace obby::solve

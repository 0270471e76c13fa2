// A query and its level, as records and compiled. Searches and the verifier need both.
#pragma once

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/model/problem.h"
#include "solve/model/trajectory.h"

namespace obby::solve {

// All that it refers to must outlive it.
struct PosedQuery {
  const level::Level& level;
  schema::Level::Reader levelRecord;
  const level::Query& query;
  schema::Query::Reader queryRecord;
  const policy::Network* policy = nullptr;  // for methods that use one
};

// Returns a problem that is valid while all that `posed` refers to lives.
Problem problemOf(const PosedQuery& posed);

// Returns true if the verifier agrees that the trajectory solves the query.
bool solves(const Trajectory& trajectory, const PosedQuery& posed);

}  // namespace obby::solve

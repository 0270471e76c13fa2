// A query together with the level that it is asked of, as records and compiled: what a search and
// the verifier need of the two.
#pragma once

#include "level/level.h"
#include "schema/obby.capnp.h"
#include "solve/model/playthrough.h"
#include "solve/model/problem.h"

namespace obby::solve {

// Everything in it must outlive it.
struct PosedQuery {
  const level::Level& level;
  schema::Level::Reader levelRecord;
  const level::Query& query;
  schema::Query::Reader queryRecord;
  const policy::Network* policy = nullptr;  // for methods that use one
};

// Valid while what it was made of lives.
Problem problemOf(const PosedQuery& posed);

// Does the verifier agree that this playthrough solves it?
bool solves(const Playthrough& playthrough, const PosedQuery& posed);

}  // namespace obby::solve

// How much a query asks for, told from the level and the query alone. It sorts the suite into easy
// and hard thirds: thirds by the time of one method would flatter every other one, since what was
// slow by bad luck is not slow again.
#pragma once

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::bench {

// The sum of
//   1    for every 8.6 studs (a jump on the flat) of the straight way from the start over the
//        waypoints to the nearest goal, visits by the nearest first; a stud up counts three
//   1/2  for every part beside that way (within 12 studs) that kills, moves, comes and goes,
//   throws,
//        conveys or can be pushed
//   2    for every waypoint and visit
//   2    for every limit (of jumps, time, damage, states, of a segment, parts to be touched)
//   1    for every region to avoid
Result<double> effortOf(schema::Level::Reader level, schema::Query::Reader query);

}  // namespace obby::bench

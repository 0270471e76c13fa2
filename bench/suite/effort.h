// Estimates a query's difficulty from the level and the query alone. It sorts the suite into easy
// and hard thirds. Thirds by the time of one method would favour all others, since its slowest
// queries are partly bad luck.
#pragma once

#include "base/result.h"
#include "schema/obby.capnp.h"

namespace obby::bench {

// Returns the sum of
//   1    for every 8.6 studs (a jump on the flat) of the straight line from the start over the
//        waypoints to the nearest goal, visits nearest first; a stud up counts as three
//   1/2  for every part within 12 studs of that line that kills, moves, appears and disappears,
//        throws, conveys or can be pushed
//   2    for every waypoint and visit
//   2    for every limit (of jumps, time, damage, states, of a segment, parts to be touched)
//   1    for every region to avoid
Result<double> effortOf(schema::Level::Reader level, schema::Query::Reader query);

}  // namespace obby::bench

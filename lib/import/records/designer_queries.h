// Reads the queries that a designer keeps in the place, as the Studio plugin writes them. The
// folder ObbyQueries in ServerStorage (or a root of a model file) holds a Configuration for each
// query, named by its id. Below each query is a Configuration for each region.
//   query    attributes named as the number fields of the schema's Query: maxJumps, timeLimit, ...;
//            forbid: its states as a text, "climbing, seated"; startTick: the level's clock at the
//            start, in sixtieths of a second whatever the level's tick rate is
//   region   kind: start, goal, waypoint, avoid or visit; order: a number; the box as cframe and
//            size, or part (a name, path, GUID or #tag) and touch; on a waypoint also the number
//            fields of the schema's Waypoint
// The folder's own attribute `physics` holds calibrated parameters, a params record as JSON.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "import/document/tree.h"
#include "import/draft/draft.h"
#include "io/record.h"

namespace obby::importer {

// Returns the queries in the order of the file. An unusable item is left out, with a warning that
// names it. A query without a goal is left out, too. `rate` is the level's rate in ticks per
// second.
std::vector<io::RecordBuilder> designerQueries(const LevelDraft& level, const Tree& tree,
                                               uint16_t rate, std::vector<std::string>& warnings);

// Returns the calibrated parameters. Returns nullopt if the place has none, or, with a warning, if
// they cannot be read.
std::optional<io::Record> designerPhysics(const Tree& tree, std::vector<std::string>& warnings);

}  // namespace obby::importer

// What probes do, as sets of names that can be compared. Private to lib/engine.
#pragma once

#include <set>
#include <string>

#include "engine/report.h"

namespace obby::engine {

using Names = std::set<std::string>;

bool harms(const Probe& probe);
bool kills(const Probe& probe);

// What changes in a run that nobody disturbs: "target.property", and "target" of what moves.
Names namesIn(const Observation& seen);
// What a probe does besides. Names that begin with ~ are of effects that end by themselves, so that
// they may come again.
Names effectsIn(const Probe& probe, const Names& usual);
// Whether `now` has an effect that `before` lacks.
bool adds(const Names& before, const Names& now);
// Whether it has, or lacks one that may come again.
bool differ(const Names& before, const Names& now);

}  // namespace obby::engine

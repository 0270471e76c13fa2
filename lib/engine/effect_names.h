// Turns the effects of probes into sets of names, so that two probes can be compared. Private to
// lib/engine.
#pragma once

#include <set>
#include <string>

#include "engine/report.h"

namespace obby::engine {

using Names = std::set<std::string>;

bool harms(const Probe& probe);
bool kills(const Probe& probe);

// Returns the names of all changes: "target.property", "target" for each part that moves, and
// "harm".
Names namesIn(const Observation& seen);
// Returns the names of the changes between two times, in seconds.
Names namesIn(const Observation& seen, double from, double to);
// Removes the changes with one of these names from `seen`.
void drop(Observation& seen, const Names& names);
// Returns the probe's effects beyond `usual`. A leading ~ marks an effect that ends by itself and
// may come again.
Names effectsIn(const Probe& probe, const Names& usual);
// Returns true if `now` has an effect that `before` lacks.
bool adds(const Names& before, const Names& now);
// Returns true if `now` adds an effect, or lacks one of `before` that may come again.
bool differ(const Names& before, const Names& now);

}  // namespace obby::engine

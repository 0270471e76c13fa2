// The effects of probes as sets of names, so that two probes can be compared. Private to
// lib/engine.
#pragma once

#include <set>
#include <string>

#include "engine/report.h"

namespace obby::engine {

using Names = std::set<std::string>;

bool harms(const Probe& probe);
bool kills(const Probe& probe);

// The changes in a run without touches: "target.property", and "target" for each part that moves.
Names namesIn(const Observation& seen);
// Those between two times.
Names namesIn(const Observation& seen, double from, double to);
// Takes out of `seen` what has one of these names.
void drop(Observation& seen, const Names& names);
// The probe's effects beyond `usual`. A leading ~ marks an effect that ends by itself and may come
// again.
Names effectsIn(const Probe& probe, const Names& usual);
// Whether `now` has an effect that `before` lacks.
bool adds(const Names& before, const Names& now);
// True if `now` adds an effect, or lacks one of `before` that may come again.
bool differ(const Names& before, const Names& now);

}  // namespace obby::engine

// Writers of the pieces of the page's data.
#pragma once

#include "io/json_writer.h"
#include "view/budget.h"
#include "view/report.h"

namespace obby::view {

// Returns the error for a page over kPageLimit. `full`: nothing was thinned.
Error pageTooLarge(size_t bytes, bool full);

// Increased when a field changes its meaning.
inline constexpr int kPageFormat = 4;

// Writes an array of sentences.
void writeNotes(io::JsonWriter& json, const Report& report, const Budget& budget);
void writeLevel(io::JsonWriter& json, const LevelEntry& entry, uint32_t ticksShown,
                uint32_t trackStride);
// Writes the members of a query's object except its trajectories.
void writeQueryFacts(io::JsonWriter& json, const QueryEntry& entry);
// Writes every `stride`-th tick.
void writePath(io::JsonWriter& json, const PathEntry& path, uint32_t stride);
void writeQuery(io::JsonWriter& json, const QueryEntry& entry, const Budget& budget);

}  // namespace obby::view

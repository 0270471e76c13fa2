// The pieces of the page's data.
#pragma once

#include "view/budget.h"
#include "view/json_text.h"
#include "view/report.h"

namespace obby::view {

// What is said of a page over kPageLimit. `full`: nothing of it was thinned out.
Error pageTooLarge(size_t bytes, bool full);

// Raised when a field of the data changes its meaning.
inline constexpr int kPageFormat = 3;

// An array of sentences.
void writeNotes(JsonText& json, const Report& report, const Budget& budget);
void writeLevel(JsonText& json, const LevelEntry& entry, uint32_t ticksShown, uint32_t trackStride);
// The members of a query's object but its trajectories.
void writeQueryFacts(JsonText& json, const QueryEntry& entry);
// Every `stride`-th tick of it.
void writePath(JsonText& json, const PathEntry& path, uint32_t stride);
void writeQuery(JsonText& json, const QueryEntry& entry, const Budget& budget);

}  // namespace obby::view

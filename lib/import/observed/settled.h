// Lists script changes to the file's parts before play began, for the evidence.
#pragma once

#include <vector>

#include "import/document/observed_place.h"

namespace obby::importer {

// Returns the parts that differ between the file and the document that `settle` made from it.
std::vector<Settled> settledIn(const Document& file, const Document& document,
                               const engine::Report& report);

}  // namespace obby::importer

// What scripts had made of the file's parts when play began, for the evidence.
#pragma once

#include <vector>

#include "import/observed/place.h"

namespace obby::importer {

// Parts that differ between the file and the document that `settle` has made of it.
std::vector<Settled> settledIn(const Document& file, const Document& document,
                               const engine::Report& report);

}  // namespace obby::importer

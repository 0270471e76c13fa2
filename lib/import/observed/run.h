// Runs a place's scripts and returns the document in the state after them.
#pragma once

#include "import/document/observed_place.h"

namespace obby::importer {

// Runs the scripts in a child process. A document without scripts is returned unchanged.
ObservedPlace observePlace(const Document& document);

}  // namespace obby::importer

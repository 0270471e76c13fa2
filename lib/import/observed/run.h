// Runs a place's scripts and brings the document to the state in which they leave it.
#pragma once

#include "import/observed/place.h"

namespace obby::importer {

// A document without scripts comes back as it is.
ObservedPlace observePlace(const Document& document);

}  // namespace obby::importer

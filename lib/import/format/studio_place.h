// Unpacks a place as the Studio plugin sends it. Studio serialises no services, so the plugin sends
// a model. The children of Workspace are roots. A Configuration `ObbyPlace` has a child for each
// service: its name is the service's, its attributes are the properties, and the scripts are below
// it (docs/studio.md).
#pragma once

#include "engine/document.h"

namespace obby::importer {

// Turns a model from the plugin into the place. Any other document stays unchanged.
void unpackStudioPlace(Document& document);

}  // namespace obby::importer

// A place as the Studio plugin sends it. Studio serialises no services, so what it sends is a
// model: what stands in Workspace as roots, and a Configuration `ObbyPlace` with a child for each
// service, which has the service's name, its properties as attributes and its scripts below it
// (docs/studio.md).
#pragma once

#include "engine/document.h"

namespace obby::importer {

// Makes such a model the place that it is of; any other document stays as it is.
void unpackStudioPlace(Document& document);

}  // namespace obby::importer

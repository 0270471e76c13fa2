// The engine's frame.
#pragma once

#include "engine/observation.h"

namespace obby::importer {

using engine::kFrame;

}  // namespace obby::importer
